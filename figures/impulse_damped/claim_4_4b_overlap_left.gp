# Overlap in each tenth of a second: without a response, found by the pass, left by it.
tall = 620
@PAGE
set lmargin at screen 0.18; set rmargin at screen 0.95
set key at screen 0.565,0.985 center top vertical maxcols 1
set tmargin at screen 0.78; set bmargin at screen 0.17
set logscale y; set format y powers
set xrange [0:*]; set xtics 1
set yrange [1e-5:*]
set xlabel 'time [s]'
side = 'overlap of all pairs [m]'; @SIDE
shown(x) = x > 0 ? x : NaN
plot stem.'.csv' using 'time_s':(shown(column('free_m'))) with lines lt 1 title 'if no impulse had acted', \
  '' using 'time_s':(shown(column('found_m'))) with lines lt 2 title 'found by the pass', \
  '' using 'time_s':(shown(column('loose_found_m'))) with lines lt 4 title 'found by it, no damping', \
  '' using 'time_s':(shown(column('left_m'))) with points lt 3 title 'left by it'
