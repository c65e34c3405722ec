# Force at the column's pivot during the fall on the closed form, the friction it takes, and errors.
tall = 1300
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
marks = stem.'_marks.csv'
stats marks using 'opens_s' nooutput
opens = STATS_max
stats stem.'.csv' using 'time_s' nooutput
last = STATS_max
set xrange [0:last]; set format x ''
every_some = 3
set arrow 1 from opens,graph 0 to opens,graph 1 nohead lt 8 dt (6,4)

set tmargin at screen 0.94; set bmargin at screen 0.63
set yrange [-1.6:1.15]; set ytics -1.5,0.5
side = 'force over weight'; @SIDE
set key at screen 0.55,0.995 center top vertical maxrows 2 width -2
set label 1 'glue pulls' at opens,graph 0.07 left offset 0.6,0 textcolor rgb soft
set label 2 'all pressed' at opens,graph 0.07 right offset -0.6,0 textcolor rgb soft
plot stem.'.csv' using 'time_s':'normal' with lines lt 1 dt 1 title 'normal, exact', \
  '' using 'time_s':'rk4_normal' every every_some with points lt 1 title 'Runge-Kutta 4', \
  '' using 'time_s':'tangential' with lines lt 2 dt 1 title 'tangential, exact', \
  '' using 'time_s':'rk4_tangential' every every_some with points lt 2 title 'Runge-Kutta 4'
unset key; unset label 1; unset label 2

set tmargin at screen 0.61; set bmargin at screen 0.4
set logscale y
set yrange [0.05:60]; set ytics (0.1, 1, 10); unset mytics
side = 'friction it takes'; @SIDE
set arrow 2 from graph 0,first 1 to graph 1,first 1 nohead lc rgb '#dddddd' lw 0.7
plot stem.'.csv' using 'time_s':'friction' with lines lt 3 dt 1, \
  '' using 'time_s':'rk4_friction' every every_some with points lt 3
unset arrow 2

set tmargin at screen 0.31; set bmargin at screen 0.07
set format x '%g'
set xlabel 'time [s]' offset 0,0.3
set format y powers
set yrange [1e-17:1]; set ytics 1e-16,1e4
side = 'error over weight'; @SIDE
set key at screen 0.55,0.378 center top vertical maxrows 3 width -2
plot stem.'.csv' using 'time_s':'semi_implicit_error' with lines lt 2 title 'semi-implicit Euler', \
  '' using 'time_s':'rk4_error' with lines lt 1 title 'Runge-Kutta 4', \
  '' using 'time_s':'dormand_prince_error' with lines lt 8 title 'Dormand-Prince 5, adaptive'
unset multiplot
