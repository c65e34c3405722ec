# Pairs tested and impulses in a step against the number of boxes.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
pyramid = stem.'_pyramid.csv'
set logscale xy
set xrange [7:150]; set xtics (10, 20, 50, 100)
set format y powers
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.8; set bmargin at screen 0.49
set format x ''
set yrange [0.01:2e4]; set ytics 100
side = 'pairs tested in a step'; @SIDE
plot stem.'.csv' using 'boxes':(0.5*column('boxes')*(column('boxes')+1)) with lines lt 8 title 'all pairs', \
  '' using 'boxes':'tests' with linespoints lt 1 title 'clump, damped as in the thesis', \
  '' using 'boxes':'tests_coulomb' with linespoints lt 2 title 'clump, contact\_damped', \
  pyramid using 'boxes':'tests' with linespoints lt 3 title 'pyramid, damped as in the thesis', \
  '' using 'boxes':'tests_coulomb' with linespoints lt 4 title 'pyramid, contact\_damped'

unset key
set tmargin at screen 0.45; set bmargin at screen 0.135
set format x '%g'
set xlabel 'boxes' offset 0,0.3
set yrange [0.1:2e4]; set ytics 10
side = 'impulses in a step'; @SIDE
plot stem.'.csv' using 'boxes':'impulses' with linespoints lt 1, \
  '' using 'boxes':'impulses_coulomb' with linespoints lt 2, \
  pyramid using 'boxes':'impulses' with linespoints lt 3, \
  '' using 'boxes':'impulses_coulomb' with linespoints lt 4
