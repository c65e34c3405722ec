# What is wrong after one step of a cube that sticks, slides or flies, by the point about which it was turned.
tall = 1060
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955
of(s, c, name) = column('situation') == s && column('centre') == c ? column(name) : NaN
most(s, c) = column('situation') == s && column('centre') == c ? (column('gap_m') > column('bend_m') ? column('gap_m') : column('bend_m')) : 0
stats stem.'.csv' using (0*column('gap_m') + most(1, 2)) every ::1 nooutput
stuck = STATS_max
stats stem.'.csv' using (0*column('gap_m') + most(2, 4)) every ::1 nooutput
slid = STATS_max
stats stem.'.csv' using (0*column('gap_m') + most(3, 1)) every ::1 nooutput
flown = STATS_max
set logscale xy; set format y powers
set xrange [0.0009:0.23]; set xtics (0.001, 0.003, 0.01, 0.03, 0.1)
set yrange [1e-7:0.3]; set ytics 1e-7,100
set label 1 '' at graph 0.03,0.93 left textcolor rgb '#202020'
set label 2 '' at graph 0.98,0.09 right textcolor rgb soft

set key at screen 0.56,0.992 center top vertical maxrows 2 width -2 title 'turned about'
set tmargin at screen 0.91; set bmargin at screen 0.665
set format x ''
side = 'gap [m]'; @SIDE
set label 1 'it sticks'
set label 2 sprintf('about the touching point: %.0g m', stuck)
plot stem.'.csv' using 'step_s':(of(1, 1, 'predicted_m')) with lines lt 8 notitle, \
  '' using 'step_s':(of(1, 1, 'error_m')) with points lt 2 ps 1.1 title 'its centre', \
  '' using 'step_s':(NaN) with points lt 1 ps 1.1 title 'the touching point', \
  '' using 'step_s':(NaN) with points lt 3 ps 1.2 title 'what is at rest'
unset key
set tmargin at screen 0.635; set bmargin at screen 0.39
side = 'gap or bend [m]'; @SIDE
set label 1 'it slides'
set label 2 sprintf('centre straight, put back on the ground: %.0g m', slid)
plot for [c=1:3] stem.'.csv' using 'step_s':(of(2, c, 'predicted_m')) with lines lt 8 notitle, \
  '' using 'step_s':(of(2, 1, 'error_m')) with points lt 2 ps 1.1, \
  '' using 'step_s':(of(2, 2, 'error_m')) with points lt 1 ps 1.1, \
  '' using 'step_s':(of(2, 3, 'error_m')) with points lt 3 ps 1.2
set tmargin at screen 0.36; set bmargin at screen 0.08
set format x '%g'
set xlabel 'length of the step [s]' offset 0,0.3
side = 'bend [m]'; @SIDE
set label 1 'it flies'
set label 2 sprintf('about its centre: %.0g m', flown)
plot stem.'.csv' using 'step_s':(of(3, 3, 'predicted_m')) with lines lt 8 notitle, \
  '' using 'step_s':(of(3, 3, 'error_m')) with points lt 3 ps 1.2
