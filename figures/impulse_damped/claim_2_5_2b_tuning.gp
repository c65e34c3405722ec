# Deepest overlap over the settings: penalty forces against their stiffness, impulses against their passes.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set logscale xy
set format y powers
set yrange [0.1:1e4]
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.87; set bmargin at screen 0.57
set format x powers
set xrange [60:1.6e6]
set xlabel 'stiffness of penalty forces [N/m]' offset 0,0.3
side = 'deepest overlap [mm]'; @SIDE
set arrow 1 from graph 0,first 10 to graph 1,first 10 nohead lt 8 dt (6,4)
shift(r) = (r/85.0)**0.12
plot stem.'.csv' using (column('stiffness')*shift(column('rate'))):(column('scenes') < 3 ? 1e3*column('deepest_m') : NaN) with points lt 2 title 'a scene is not carried', \
  '' using (column('stiffness')*shift(column('rate'))):(column('scenes') == 3 ? 1e3*column('deepest_m') : NaN) with points lt 1 title 'all three are'
unset key
set tmargin at screen 0.45; set bmargin at screen 0.12
set format x '%g'
set xrange [0.8:25]; set xtics (1, 2, 5, 10, 20)
set xlabel 'passes of impulses' offset 0,0.3
side = 'deepest overlap [mm]'; @SIDE
some(x) = x > 1e-4 ? x : 1e-4
plot stem.'_impulse.csv' using (column('passes')*shift(column('rate'))):(column('scenes') < 3 ? 1e3*some(column('deepest_m')) : NaN) with points lt 2, \
  '' using (column('passes')*shift(column('rate'))):(column('scenes') == 3 ? 1e3*some(column('deepest_m')) : NaN) with points lt 1
