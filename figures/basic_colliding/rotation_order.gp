# Error of the orientation against the step, for each rotation rule.
tall = 580
@PAGE
set lmargin at screen 0.18; set rmargin at screen 0.95
set tmargin at screen 0.80; set bmargin at screen 0.16

# The measured orders stand in the file of numbers, one row for each rule.
array order[4]
do for [row=1:4] {
  stats stem.'_numbers.csv' using 'value' every ::(row - 1)::(row - 1) name 'number' nooutput
  order[row] = number_mean
}
name(rule, row) = sprintf('%s: slope %.2f', rule, order[row])

set logscale xy
set format x powers; set format y powers
set xrange [*:*] noextend
set yrange [1e-16:10]; set ytics 1e-16,1e4
set xlabel 'step [s]'
side = 'angle error [rad]'; @SIDE
set key at screen 0.56,0.985 center top vertical maxcols 1
plot stem.'.csv' using 'step_s':'frozen_rad' with linespoints lt 2 title name('frozen', 1), \
  '' using 'step_s':'midpoint_rad' with linespoints lt 3 title name('midpoint', 2), \
  '' using 'step_s':'splitting_rad' with linespoints lt 4 title name('splitting', 4), \
  '' using 'step_s':'rk4_rad' with linespoints lt 1 title name('Runge–Kutta', 3)
