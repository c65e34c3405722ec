# Work of a step against the share of boxes that move; boxes awake after one was taken away.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.88; set bmargin at screen 0.6
set key at screen 0.56,0.985 center top vertical maxcols 1
set xrange [0:1]; set xtics 0,0.2
set yrange [0:*]; set ytics 0,1000
set xlabel 'fraction of boxes that move' offset 0,0.3
side = 'counts a step'; @SIDE
plot stem.'.csv' using 'moving':'work_awake' with linespoints lt 2 title 'nothing sleeps', \
  '' using 'moving':'work' with linespoints lt 1 title 'boxes at rest sleep'

set tmargin at screen 0.37; set bmargin at screen 0.13
set key at screen 0.56,0.465 center top vertical maxcols 1
set xrange [0:90]; set xtics 0,15
set yrange [0:5]; set ytics 0,1
set xlabel 'steps after a box was taken away' offset 0,0.3
side = 'boxes awake'; @SIDE
wake = stem.'_wake.csv'
plot wake using 'step':'awake_lowest' with steps lt 1 title 'the lowest of a stack', \
  '' using 'step':'awake_highest' with steps lt 2 title 'the uppermost'
