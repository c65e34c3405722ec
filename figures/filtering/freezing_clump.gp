# A clump under damped: bodies awake, bodies that chatter, and the work, for three ways to sleep.
tall = 1200
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
stats stem.'.csv' using 'time_s' name 'time' nooutput
stats stem.'.csv' using 'cube_s' name 'cube' nooutput
set arrow 1 from cube_max,graph 0 to cube_max,graph 1 nohead lt 8 dt (6,4) back
set xrange [0:time_max]; set xtics 0,3
set format x ''
set key at screen 0.56,0.995 center top horizontal maxcols 3

set tmargin at screen 0.925; set bmargin at screen 0.655
side = 'bodies awake'; @SIDE
set yrange [0:140]; set ytics 0,25
set label 1 'a cube comes in' at cube_max,60 right offset -0.6,0 textcolor rgb soft
plot stem.'.csv' using 'time_s':'off_awake' with lines lt 1 title 'no sleep', \
  '' using 'time_s':'sleeping_awake' with lines lt 2 title 'by speed', \
  '' using 'time_s':'freezing_awake' with lines lt 3 dt 1 lw 3 title 'by history'
unset key; unset label 1

set tmargin at screen 0.625; set bmargin at screen 0.37
side = 'bodies that chatter'; @SIDE
set yrange [0:90]; set ytics 0,20
plot stem.'.csv' using 'time_s':'off_chatters' with lines lt 1, \
  '' using 'time_s':'sleeping_chatters' with lines lt 2, \
  '' using 'time_s':'freezing_chatters' with lines lt 3 dt 1 lw 3

set tmargin at screen 0.34; set bmargin at screen 0.075
side = 'pair tests in a step'; @SIDE
set format x '%g'
set xlabel 'time [s]' offset 0,0.3
# No test at all lies on the lowest line.
on(n) = n > 10 ? n : 10
set logscale y; set yrange [9.99:20000]; set ytics ('≤ 10' 10, '100' 100, '1000' 1000, '10000' 10000)
plot stem.'.csv' using 'time_s':(on(column('off_pair_tests'))) with lines lt 1, \
  '' using 'time_s':(on(column('sleeping_pair_tests'))) with lines lt 2, \
  '' using 'time_s':(on(column('freezing_pair_tests'))) with lines lt 3 dt 1 lw 3
