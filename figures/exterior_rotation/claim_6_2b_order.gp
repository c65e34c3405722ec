# Errors of the falling column against the step on log axes, and the gap constants of the first order.
tall = 1560
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
constants = stem.'_constants.csv'
array columns[7] = ['forward_euler', 'semi_implicit', 'impulse', 'midpoint', 'leapfrog', 'rk4', 'dormand_prince']
array names[7] = ['forward Euler', 'semi-implicit', 'impulses', 'midpoint', 'leapfrog', 'Runge-Kutta 4', 'Dormand-Prince']
array types[7] = [1, 2, 3, 4, 5, 6, 8]
array angle[7]; array gap[7]
do for [k=1:7] {
  stats stem.'_orders.csv' using (column('scheme') == k-1 ? column('angle_order') : NaN) nooutput
  angle[k] = STATS_max
  stats stem.'_orders.csv' using (column('scheme') == k-1 ? column('gap_order') : NaN) nooutput
  gap[k] = STATS_max
}
set logscale xy
set xrange [3e-4:0.25]; set xtics 1e-4,10; set format x ''
set format y powers; unset mytics
set arrow 1 from 1./60,graph 0 to 1./60,graph 1 nohead lc rgb '#a0a0a0' lw 1 dt (6,4)

set tmargin at screen 0.895; set bmargin at screen 0.655
set yrange [3e-16:2]; set ytics 1e-15,1e3
side = 'error of the angle [rad]'; @SIDE
set label 2 'orders of the angle, fitted:' at screen 0.55,0.99 center textcolor rgb soft
set key at screen 0.55,0.982 center top vertical maxrows 4 width -4
set label 1 '1/60 s' at 1./60,2e-15 left offset 0.4,0 textcolor rgb soft
plot for [k=1:7] stem.'.csv' using 'step_s':columns[k].'_angle' with linespoints lt types[k] title sprintf('%s: %.2f', names[k], angle[k])

set tmargin at screen 0.54; set bmargin at screen 0.3
set format x powers
set yrange [3e-16:2]; set ytics 1e-15,1e3
set xlabel 'step [s]' offset 0,0.3
side = 'largest gap or overlap [m]'; @SIDE
set label 2 'orders of the gap, fitted:' at screen 0.55,0.635 center textcolor rgb soft
set key at screen 0.55,0.627 center top vertical maxrows 4 width -4
plot for [k=1:7] stem.'.csv' using 'step_s':columns[k].'_gap' with linespoints lt types[k] title sprintf('%s: %.2f', names[k], gap[k])
unset arrow 1; unset label 1; unset label 2

set tmargin at screen 0.212; set bmargin at screen 0.06
unset logscale; set format '%g'
set xrange [-0.0025:0.055]; set xtics 0,0.01
set yrange [0.22:0.75]; set ytics 0,0.1
set key at screen 0.55,0.24 center top vertical maxrows 1 width -3
side = 'gap / step [m/s]'; @SIDE
plot for [k=1:3] constants using (column('step_s') > 0 ? column('step_s') : NaN):columns[k] with linespoints lt types[k] title names[k], \
  for [k=1:3] constants using (column('step_s') == 0 ? 0 : NaN):columns[k].'_exact' with points pt 6 ps 1.8 lw 2 lc rgb '#202020' notitle, \
  for [k=1:3] constants using (column('step_s') == 0 ? 0 : NaN):columns[k].'_exact':(sprintf('%.4f', column(columns[k].'_exact'))) with labels left offset 1.3,(k == 2 ? -0.8 : 0.8) notitle, \
  for [k=1:3] constants using (column('step_s') == 0 ? 0 : NaN):columns[k] with points lt types[k] notitle
unset multiplot
