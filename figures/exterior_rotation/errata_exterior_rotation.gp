# One step with one force and torque, and what a falling column's joints have to pull with.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set key at screen 0.56,0.995 center top vertical maxcols 1

set tmargin at screen 0.905; set bmargin at screen 0.545
set xlabel 'turn in the step [rad]' offset 0,0.3
set logscale xy; set format y powers; set format x '%g'
set xrange [0.01:1]; set xtics (0.01, 0.03, 0.1, 0.3, 1)
set yrange [1e-17:30]; set ytics 1e-16,1e4
side = 'gap after one step [m]'; @SIDE
plot stem.'.csv' using 'turn_rad':'euler_m' with lines lt 2 title 'centres along tangents', \
  '' using 'turn_rad':'parabola_m' with lines lt 3 title 'centres along parabolas', \
  '' using 'turn_rad':'exponential_m' with points lt 1 title 'bodies by their twist'
unset logscale; set format '%g'

pull = stem.'_pull.csv'
set tmargin at screen 0.40; set bmargin at screen 0.1
set key at screen 0.2,0.41 left top vertical maxcols 1
set xlabel 'time since the column was released [s]' offset 0,0.3
stats pull using 'time_s' nooutput name 'T'
set xrange [0:T_max]; set xtics auto
set yrange [0:*]; set ytics auto
side = 'largest pull in a joint [N]'; @SIDE
plot pull using 'time_s':'glue_N' with lines lt 2 title 'the boxes stay connected', \
  '' using 'time_s':'dry_N' with lines lt 1 title 'they can come apart'
