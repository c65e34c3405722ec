# A box that turns over: its middle angular velocity and its energy error under each rule.
tall = 760
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set xrange [0:*] noextend

set key at screen 0.56,0.99 center top horizontal maxcols 3 width -1
set tmargin at screen 0.89; set bmargin at screen 0.53
set format x ''
set yrange [-6.5:6.5]; set ytics 5
side = 'ω_2 [rad/s]'; @SIDE
plot stem.'.csv' using 'time_s':'exact_rad_s' with lines lc rgb '#c8c8c8' lw 7 dt 1 title 'exact', \
  '' using 'time_s':'frozen_rad_s' with lines lt 2 title 'frozen', \
  '' using 'time_s':'midpoint_rad_s' with lines lt 3 title 'midpoint', \
  '' using 'time_s':'splitting_rad_s' with lines lt 4 title 'splitting', \
  '' using 'time_s':'rk4_rad_s' with lines lt 1 title 'Runge–Kutta'

unset key
set tmargin at screen 0.48; set bmargin at screen 0.125
set format x '%g'
set xlabel 'time [s]'
side = 'energy error'; @SIDE
set logscale y
set yrange [1e-12:1]; set ytics 1e-12,1e3
set format y powers
set label 'accepted' at graph 0.46,first 1e-6 center offset 0,0.6 textcolor rgb soft
plot stem.'.csv' using 'time_s':'accepted' with lines lt 8, \
  '' using 'time_s':'frozen_energy' with lines lt 2, \
  '' using 'time_s':'midpoint_energy' with lines lt 3, \
  '' using 'time_s':'splitting_energy' with lines lt 4, \
  '' using 'time_s':'rk4_energy' with lines lt 1
