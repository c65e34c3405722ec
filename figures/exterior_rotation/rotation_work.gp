# Errors of the falling column against the number of force solves, on log axes.
tall = 1500
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
adaptive = stem.'_adaptive.csv'
array columns[6] = ['forward_euler', 'semi_implicit', 'impulse', 'midpoint', 'leapfrog', 'rk4']
array names[6] = ['forward Euler', 'semi-implicit', 'impulses', 'midpoint', 'leapfrog', 'Runge-Kutta 4']
array types[6] = [1, 2, 3, 4, 5, 6]
array still[4] = ['forward_euler_exp', 'semi_implicit_exp', 'impulse_exp', 'leapfrog_exp']
array named[4] = ['forward Euler', 'semi-implicit', 'impulses', 'leapfrog']
array still_types[4] = [1, 2, 3, 5]
set logscale xy; set format y powers; unset mytics
set xrange [8:6000]; set xtics 10,10; set format x ''
set yrange [3e-16:2]; set ytics 1e-15,1e3

set tmargin at screen 0.917; set bmargin at screen 0.67
side = 'error of the angle [rad]'; @SIDE
set key at screen 0.55,0.995 center top vertical maxrows 4 width -4
plot for [k=1:6] stem.'.csv' using columns[k].'_solves':columns[k].'_angle' with linespoints lt types[k] title names[k], \
  stem.'.csv' using 'dormand_prince_solves':'dormand_prince_angle' with linespoints lt 8 title 'Dormand-Prince 5', \
  adaptive using 'solves':'angle' with points pt 6 ps 1.3 lw 2 lc rgb '#202020' title 'the same, adaptive'
unset key

set tmargin at screen 0.65; set bmargin at screen 0.395
side = 'largest gap or overlap [m]'; @SIDE
set label 1 'by exponentials, all four' at 9,8e-14 textcolor rgb soft
plot for [k=1:6] stem.'.csv' using columns[k].'_solves':columns[k].'_gap' with linespoints lt types[k], \
  for [k=1:4] '' using still[k].'_solves':still[k].'_gap' with points lt still_types[k] pt 1 ps 1, \
  '' using 'dormand_prince_solves':'dormand_prince_gap' with linespoints lt 8, \
  adaptive using 'solves':'gap' with points pt 6 ps 1.3 lw 2 lc rgb '#202020'
unset label 1

set tmargin at screen 0.3; set bmargin at screen 0.058
set format x '%g'
set xlabel 'systems of joint forces solved' offset 0,0.3
side = 'error of the angle [rad]'; @SIDE
set key at screen 0.55,0.358 center top vertical maxrows 3 width -4
set label 2 'each body by its exponential:' at screen 0.55,0.366 center textcolor rgb soft
plot for [k=1:4] stem.'.csv' using still[k].'_solves':still[k].'_angle' with linespoints lt still_types[k] title named[k], \
  '' using 'rk4_solves':'rk4_angle' with linespoints lt 6 title 'Runge-Kutta 4, separate'
unset multiplot
