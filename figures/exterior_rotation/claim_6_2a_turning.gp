# A column that turns against one that is pushed along; the gap that a step makes against its length.
tall = 920
@PAGE
set multiplot
table = stem.'.csv'
steps = stem.'_steps.csv'
set lmargin at screen 0.17; set rmargin at screen 0.955
set logscale y; set format y powers; unset mytics

set tmargin at screen 0.945; set bmargin at screen 0.615
set xrange [0:1]; set xtics nomirror 0,0.2
set yrange [1e-17:1]; set ytics nomirror 1e-15,1e3
set xlabel 'time [s]' offset 0,0.3
side = 'gap / edge'; @SIDE
set key at screen 0.56,0.995 center top horizontal maxcols 2 samplen 2.5 width -1
set arrow 1 from graph 0,first 1e-3 to graph 1,first 1e-3 nohead lt 8 dt (6,4)
set arrow 2 from graph 0,first 1e-4 to graph 1,first 1e-4 nohead lt 8 dt (6,4)
set label 1 'confirmed if turning exceeds 10^{-3}' at graph 0.03,first 8e-3 left textcolor rgb soft
set label 2 'and pushing stays below 10^{-4}' at graph 0.98,first 1.2e-5 right textcolor rgb soft
plot table using 'time_s':'turning_m' with lines lt 1 title 'turning', \
  '' using 'time_s':'pushed_m' with lines lt 2 title 'pushed along'
unset arrow; unset label

set tmargin at screen 0.435; set bmargin at screen 0.1
set logscale x; set xrange [0.01:0.1]; set xtics nomirror (0.01,0.02,0.05,0.1)
set yrange [1e-12:0.1]; set ytics nomirror 1e-12,1e2
set xlabel 'length of one step [s]' offset 0,0.3
side = 'gap of a step [m]'; @SIDE
set key at screen 0.56,0.505 center top vertical maxrows 2 maxcols 3 samplen 1.8 width -1
plot steps using 'step_s':'arc_m' with lines lt 8 lw 5 lc rgb '#BBBBBB' title 'ω² h² s / 2', \
  '' using 'step_s':'forward_euler_m' with linespoints lt 1 pt 7 title 'forward Euler', \
  '' using 'step_s':'semi_implicit_m' with linespoints lt 2 title 'semi-implicit', \
  '' using 'step_s':'impulse_m' with linespoints lt 3 title 'impulses', \
  '' using 'step_s':'midpoint_m' with linespoints lt 4 title 'midpoint', \
  '' using 'step_s':'rk4_m' with linespoints lt 5 title 'rk4'
