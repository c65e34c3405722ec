# A box that turns over: its middle angular velocity and its energy error under each rule, and a
# table of the errors of its first flip.
tall = 1030
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set xrange [0:*] noextend

set key at screen 0.56,0.99 center top horizontal maxcols 3 width -1
set tmargin at screen 0.918; set bmargin at screen 0.655
set format x ''
set yrange [-6.5:6.5]; set ytics 5
side = 'ω_2 [rad/s]'; @SIDE
plot stem.'.csv' using 'time_s':'exact_rad_s' with lines lc rgb '#c8c8c8' lw 7 dt 1 title 'exact', \
  '' using 'time_s':'frozen_rad_s' with lines lt 2 title 'frozen', \
  '' using 'time_s':'midpoint_rad_s' with lines lt 3 title 'midpoint', \
  '' using 'time_s':'splitting_rad_s' with lines lt 4 title 'splitting', \
  '' using 'time_s':'rk4_rad_s' with lines lt 1 title 'Runge–Kutta'

unset key
set tmargin at screen 0.62; set bmargin at screen 0.36
set format x '%g'
set xlabel 'time [s]'
side = 'energy error'; @SIDE
set logscale y; unset mytics
set yrange [1e-12:1]; set ytics 1e-12,1e3
set format y powers
set label 'accepted' at graph 0.46,first 1e-6 center offset 0,0.6 textcolor rgb '#0072B2'
plot stem.'.csv' using 'time_s':'accepted' with lines lt 1 lw 1.2, \
  '' using 'time_s':'frozen_energy' with lines lt 2, \
  '' using 'time_s':'midpoint_energy' with lines lt 3, \
  '' using 'time_s':'splitting_energy' with lines lt 4, \
  '' using 'time_s':'rk4_energy' with lines lt 1

# The table: a row for each step, a column for each rule.
unset logscale; unset border; unset tics; unset grid; unset xlabel; unset label
set lmargin at screen 0.03; set rmargin at screen 0.98
set tmargin at screen 0.222; set bmargin at screen 0.005
set xrange [0:4.7]; set yrange [-4.1:1]
set label 1 'error of the first flip [s]' at graph 0.5,1.03 center textcolor rgb '#202020'
set label 2 'step [s]' at 0.35,0.5 center textcolor rgb soft
titles = 'frozen midpoint splitting Runge–Kutta'
colours = '#D55E00 #009E73 #CC79A7 #0072B2'
do for [k=1:4] {
  set label 2 + k word(titles, k) at k + 0.2,0.5 center textcolor rgb word(colours, k)
}
set arrow 9 from 0,0 to 4.7,0 nohead lc rgb '#808080' lw 1
shown(value) = gprintf('%.1t·10^{%T}', value)
# Columns are: step, then the rules in the order of the program.
place = '2 3 5 4'
plot stem.'_flips.csv' using (0.35):(-0.5 - $0):(sprintf('1/%.0f', 1.0/$1)) every ::1 with labels, \
  for [k=1:4] '' using (k + 0.2):(-0.5 - $0):(shown(column(int(word(place, k))))) every ::1 with labels
