# Tests of pairs of bounds per step, against the number of bodies.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale xy
set xrange [1.8:4000]
set format y powers
set arrow 1 from 1000,graph 0 to 1000,graph 1 nohead lt 8 dt (6,4)

set tmargin at screen 0.85; set bmargin at screen 0.40
set format x ''
set yrange [0.4:1e7]; set ytics 1,10
side = 'tests per step'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 4
plot stem.'.csv' using 'bodies':'all_pairs' with linespoints lt 2 title 'all pairs', \
  '' using 'bodies':'bounding_tree' with linespoints lt 3 title 'bounding tree', \
  '' using 'bodies':'hashed_grid' with linespoints lt 4 title 'hashed grid', \
  '' using 'bodies':'sweep_and_prune' with linespoints lt 1 title 'sweep and prune', \
  '' using 'bodies':'kd_tree' with linespoints lt 5 title 'kd-tree', \
  '' using 'bodies':'octree' with linespoints lt 6 title 'octree', \
  '' using 'bodies':'overlaps' with lines lt 8 title 'bounds that overlap'

unset key
set tmargin at screen 0.36; set bmargin at screen 0.105
set format x '%g'
set xlabel 'bodies'
set yrange [0.5:1000]
side = 'times fewer tests'; @SIDE
set label 1 'decides' at 1000,1 right offset -0.7,-0.4 textcolor rgb soft
set label 2 'confirmed above 10' at 2,10 offset 0,0.7 textcolor rgb soft
set arrow 2 from graph 0,first 10 to graph 1,first 10 nohead lt 8 dt (2,4)
set arrow 3 from graph 0,first 1 to graph 1,first 1 nohead lt 8
plot stem.'.csv' using 'bodies':(column('all_pairs')/column('bounding_tree')) with linespoints lt 3, \
  '' using 'bodies':(column('all_pairs')/column('hashed_grid')) with linespoints lt 4, \
  '' using 'bodies':(column('all_pairs')/column('kd_tree')) with linespoints lt 5, \
  '' using 'bodies':(column('all_pairs')/column('octree')) with linespoints lt 6, \
  '' using 'bodies':(column('all_pairs')/column('sweep_and_prune')) with linespoints lt 1
