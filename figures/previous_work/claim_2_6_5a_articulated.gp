# Multiplications of one solve of all joint forces against the number of links.
tall = 520
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.82; set bmargin at screen 0.15
set logscale xy; set format y powers
set xrange [8:130000]; set xtics ('10' 10, '100' 100, '1000' 1000, '10 000' 10000, '100 000' 100000)
set yrange [1e3:1e12]; set ytics 1e3,1e3; unset mytics
set xlabel 'links'
side = 'multiplications'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 2
plot stem.'.csv' using 'links':'chain' with linespoints lt 1 title 'chain', \
  '' using 'links':'tree' with linespoints lt 2 dt 2 pt 6 title 'tree', \
  '' using 'links':'dense' with lines lt 8 title 'dense factor'
