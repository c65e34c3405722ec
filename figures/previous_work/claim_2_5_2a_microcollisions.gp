# Impacts of a second that carry a stack of cubes, against its height.
tall = 520
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.82; set bmargin at screen 0.15
set logscale xy; set format y powers
set xrange [0.9:7]; set xtics (1, 2, 3, 4, 6)
set yrange [50:1e5]; set ytics 1,10
set xlabel 'cubes on one another'
side = 'impacts per second'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 2
plot stem.'.csv' using 'cubes':'impacts_per_s' with linespoints lt 1 title 'microcollisions', \
  '' using 'cubes':'square_per_s' with lines lt 8 dt (2,4) title 'square of the height'
