# The gap that one step leaves: over its leading order above, magnitudes on log axes below.
tall = 1060
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
array columns[6] = ['forward_euler', 'impulse', 'semi_implicit', 'midpoint', 'leapfrog', 'rk4']
array names[6] = ['forward Euler', 'impulses', 'semi-implicit Euler', 'midpoint', 'leapfrog', 'Runge-Kutta 4']
array types[6] = [1, 3, 2, 4, 5, 6]
set logscale x
set xrange [4e-4:0.09]
set xtics ('' 1./960, '' 1./240, '' 1./60, '' 1./15); unset mxtics

set tmargin at screen 0.915; set bmargin at screen 0.52
set yrange [-1.15:1.25]; set ytics -1,0.5
side = 'gap over ½ (turn)² × 1 m'; @SIDE
set key at screen 0.55,0.993 center top vertical maxrows 3 width -3
set arrow 1 from graph 0,first 1 to graph 1,first 1 nohead lt 8 dt (6,4)
set arrow 2 from graph 0,first -1 to graph 1,first -1 nohead lt 8 dt (6,4)
set label 1 'opens' at 5e-4,0.87 textcolor rgb soft
set label 2 'overlaps' at 5e-4,-0.87 textcolor rgb soft
plot for [k=1:6] stem.'.csv' using 'step_s':(column(columns[k])/column('predicted')) with linespoints lt types[k] title names[k]
unset key; unset arrow; unset label 1; unset label 2

set tmargin at screen 0.48; set bmargin at screen 0.085
set xtics ('1/960' 1./960, '1/240' 1./240, '1/60' 1./60, '1/15' 1./15)
set xlabel 'length of the step [s]' offset 0,0.3
set logscale y; set format y powers; unset mytics
set yrange [1e-15:1e-1]; set ytics 1e-15,1e3
side = 'magnitude of the gap [m]'; @SIDE
set label 3 'slope 2' at 1.2e-3,6e-5 textcolor rgb soft
set label 4 'slope 3' at 1.5e-3,6e-11 textcolor rgb soft
set label 5 'slope 5' at 8.5e-3,5e-13 textcolor rgb soft
plot stem.'.csv' using 'step_s':'predicted' with lines lt 8 dt (6,4), \
  for [k=1:6] '' using 'step_s':(abs(column(columns[k]))) with linespoints lt types[k]
unset multiplot
