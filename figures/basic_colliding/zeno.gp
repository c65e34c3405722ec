# A bouncing box: its height, the speed that each impact leaves, the error of the impact times.
tall = 900
@PAGE
set multiplot
impacts = stem.'_impacts.csv'
stats impacts using 'rest_s' name 'rest' nooutput
stats impacts using 'threshold_m_s' name 'threshold' nooutput
set lmargin at screen 0.18; set rmargin at screen 0.95
set xrange [0:1.06*rest_max]
set arrow 1 from rest_max,graph 0 to rest_max,graph 1 nohead lt 8 dt (6,4)

unset key
set tmargin at screen 0.97; set bmargin at screen 0.68
set format x ''
set yrange [0:*]
side = 'height [m]'; @SIDE
set label 1 'at rest' at rest_max,graph 0.93 right offset -0.7,0 textcolor rgb soft
plot stem.'.csv' using 'time_s':'height_m' with lines lt 1
unset label 1

set key at screen 0.56,0.67 center top horizontal
set tmargin at screen 0.61; set bmargin at screen 0.36
side = 'rebound [m/s]'; @SIDE
set logscale y
set autoscale y
set ytics 1e-15,10
set format y powers
set label 2 'sticks below' at graph 0.01,first threshold_max offset 0,0.6 textcolor rgb soft
plot threshold_max with lines lt 8 notitle, \
  impacts using 'exact_s':'exact_m_s' with points pt 6 ps 1.5 lc rgb '#D55E00' title 'closed form', \
  '' using 'time_s':'rebound_m_s' with points lt 1 title 'event search'
unset label 2

unset key
set tmargin at screen 0.32; set bmargin at screen 0.105
set format x '%g'
set xlabel 'time [s]'
side = 'error of the time [s]'; @SIDE
set yrange [*:*]
plot impacts using 'exact_s':'accepted_s' with lines lt 8, \
  '' using 'exact_s':'accepted_s':('accepted') every ::0::0 with labels right offset -0.5,0.3 textcolor rgb soft, \
  '' using 'exact_s':(abs(column('time_s') - column('exact_s'))) with points lt 1
