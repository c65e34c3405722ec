# Five errata, one in each row: on the left the text taken literally, on the right corrected.
tall = 1560
@PAGE
set multiplot
unset key
top(row) = 0.935 - 0.187*row
set label 90 'taken literally' at screen 0.34,0.985 center
set label 91 'corrected' at screen 0.77,0.985 center
LEFT = 'set lmargin at screen 0.15; set rmargin at screen 0.53'
RIGHT = "set lmargin at screen 0.58; set rmargin at screen 0.96; set format y ''; unset label 90; unset label 91; unset label 92; unset label 99"
ROW = "set tmargin at screen top(row); set bmargin at screen top(row)-0.102; set label 92 title_of_row at screen 0.02,top(row)+0.017 textcolor rgb '#202020'; set label 99 side at screen 0.027,top(row)-0.051 center rotate textcolor rgb '#202020'"
NEXT = "set format y '%g'"

# T5: three cubes on a line, each a band as wide as the cube.
row = 0
title_of_row = 'T5  a test at the end of the step only'
side = 'position [m]'
@ROW
set xlabel 'time [s]' offset 0,0.4
set xrange [0:1]; set xtics 0.5
set yrange [-1.3:4.7]; set ytics 2
set style fill solid 0.55 noborder
words = 'first_m second_m third_m'
colours = '#56B4E9 #E69F00 #009E73'
@LEFT
set label 1 'passed through' at first 0.97,-0.75 right front
plot for [k=1:3] stem.'_pass_literal.csv' using 'time_s':(column(word(words,k))-0.5):(column(word(words,k))+0.5) with filledcurves lc rgb word(colours,k), \
  for [k=1:3] '' using 'time_s':word(words,k) with lines lw 2 dt 1 lc rgb word(colours,k)
unset label 1
@RIGHT
plot for [k=1:3] stem.'_pass_mended.csv' using 'time_s':(column(word(words,k))-0.5):(column(word(words,k))+0.5) with filledcurves lc rgb word(colours,k), \
  for [k=1:3] '' using 'time_s':word(words,k) with lines lw 2 dt 1 lc rgb word(colours,k)
@NEXT

# T6: a slow landing, ever shorter flights.
row = 1
title_of_row = 'T6  nothing ends a train of impacts'
side = 'impacts'
@ROW
set xlabel 'time since the first [ms]'
set xrange [0:12]; set xtics 5
set logscale y; set yrange [0.8:3000]; set ytics 1,10
@LEFT
set label 1 'stopped by a limit' at first 9.6,900 right
plot stem.'_flights_literal.csv' using 'since_ms':'impacts' with linespoints lt 2 dt 1
unset label 1
@RIGHT
set label 1 'sticks' at first 9.6,30 right
plot stem.'_flights_mended.csv' using 'since_ms':'impacts' with linespoints lt 1
unset label 1; unset logscale y
@NEXT

# T7: which end of the bracket is kept.
row = 2
title_of_row = 'T7  which end of the bracket is kept'
side = 'gap [µm]'
@ROW
set xlabel 'time since they met [µs]'
set xrange [-2:6]; set xtics 2
set yrange [-1.3:2]; set ytics 1
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 lw 1 dt (3,3)
@LEFT
set label 1 'again and again' at first 0.3,-1
plot stem.'_side_literal.csv' using 'since_us':'gap_um' with lines lt 2 dt 1, \
  '' using 'since_us':'impact_um' with points lt 2 ps 1
unset label 1
@RIGHT
set label 1 'once' at first -0.1,0.8
plot stem.'_side_mended.csv' using 'since_us':'gap_um' with lines lt 1, \
  '' using 'since_us':'impact_um' with points lt 1 ps 1.2
unset label 1; unset arrow 1
@NEXT

# T8: an Euler step against a flight; the closed form is the wide grey line.
row = 3
title_of_row = 'T8  what moves the bodies during the search'
side = 'height [mm]'
@ROW
set xlabel 'time [ms]'
set xrange [0:16]; set xtics 5
set yrange [-0.3:1.1]; set ytics 0.5
fall = stem.'_fall.csv'
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 lw 1
@LEFT
set label 1 "Euler's step" at first 0.8,0.2
plot fall using 'time_ms':'exact_mm' with lines lw 7 lc rgb '#c8c8c8', '' using 'time_ms':'euler_mm' with lines lt 2 dt 1
unset label 1
@RIGHT
set label 1 'flight' at first 3,0.35
plot fall using 'time_ms':'exact_mm' with lines lw 7 lc rgb '#c8c8c8', '' using 'time_ms':'flight_mm' with lines lt 1
unset label 1; unset arrow 1
@NEXT

# T9: the four lower corners after a flat landing.
row = 4
title_of_row = 'T9  which of four corners collides first'
side = 'corners [m]'
@ROW
set xlabel 'time since landing [ms]'
set xrange [0:100]; set xtics 0,40,80
set yrange [0:0.23]; set ytics 0.1
landing = stem.'_landing.csv'
@LEFT
set label 1 'tilts' at first 70,0.1 center
plot for [k=1:4] landing using 'time_ms':'literal'.k.'_m' with lines lt 2 dt 1
@RIGHT
set label 1 'stays level' at first 67,0.03 center
plot for [k=1:4] landing using 'time_ms':'mended'.k.'_m' with lines lt 1
