# Overlap after each step against time: the shot and the clump.
tall = 520
@PAGE
set multiplot
set tmargin at screen 0.82; set bmargin at screen 0.17
set logscale y; set format y powers
set xrange [0:4]; set xtics 1; set yrange [1e-8:1e-1]; set ytics 1e-8,100; unset mytics
set xlabel 'time [s]' offset 0,0.4
set key at screen 0.56,0.985 center top vertical maxrows 1 samplen 1.5
set lmargin at screen 0.17; set rmargin at screen 0.53
set label 1 'figure 6.6' at graph 0.05,0.93
side = 'overlap over an edge'; @SIDE
# What is 0 is drawn at the lower edge.
course(f, dt) = column('figure') == f && abs(column('dt_s') - dt) < 1e-6 ? (column('overlap') > 1e-8 ? column('overlap') : 1e-8) : NaN
plot stem.'.csv' using 'time_s':(course(1, 0.5)) with linespoints lt 1 title 'steps of 1/2 s', \
  '' using 'time_s':(course(1, 0.25)) with linespoints lt 2 title '1/4 s', \
  NaN with lines lt 3 title '1/60 s', \
  0.01 with lines lt 8 notitle
unset ylabel; set format y ''; unset key
set lmargin at screen 0.59; set rmargin at screen 0.95
set label 1 'figure 6.7'
plot stem.'.csv' using 'time_s':(course(2, 0.5)) with linespoints lt 1, \
  '' using 'time_s':(course(2, 0.25)) with linespoints lt 2, \
  '' using 'time_s':(course(2, 1/60.0)) with lines lt 3, \
  0.01 with lines lt 8
