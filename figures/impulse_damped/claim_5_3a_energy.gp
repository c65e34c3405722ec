# Largest factor of the kinetic energy, by stage and by shape; energy booked while heaps settle.
tall = 1180
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95

set tmargin at screen 0.94; set bmargin at screen 0.765
set xrange [0.4:5.6]
set xtics ('scaling' 1, 'settling' 2, "turning\nupright" 3, "slow\nparts" 4, "moves\nundone" 5) scale 0
set yrange [0.8:1.15]; set ytics 0.8,0.1
side = 'largest factor'; @SIDE
set key at screen 0.56,0.99 center top horizontal
set arrow 1 from graph 0,first 1 to graph 1,first 1 nohead lt 8 dt (6,4) back
plot stem.'.csv' using (column('stage') - 0.1):'cube' with points lt 1 ps 1.3 title 'cube', \
  '' using (column('stage') + 0.1):'brick' with points lt 2 ps 1.3 title 'brick 2×1×1', \
  '' using (column('stage') + 0.1):'brick':(sprintf('%.3f', column('brick'))) with labels offset 0,0.9 notitle

set tmargin at screen 0.59; set bmargin at screen 0.435
set xrange [0.8:8.2]; set xtics 1,1 scale 1
set xlabel 'length of a brick, over its width' offset 0,0.3
set logscale y; set yrange [0.9:10]; set ytics (1, 2, 5, 10)
side = 'largest factor'; @SIDE
set key at screen 0.56,0.68 center top vertical maxcols 1
shape = stem.'_shape.csv'
plot shape using 'length':'largest' with points lt 2 ps 1.2 title 'random states', \
  '' using 'length':'shrunk' with lines lt 1 title 'component shrunk, exact', \
  '' using 'length':'ended' with lines lt 8 dt (3,3) title 'component ended, exact'

unset logscale y; unset arrow 1; unset key
set tmargin at screen 0.305; set bmargin at screen 0.12
set xrange [0:*]; set xtics 0,1
set yrange [0:200]; set ytics 0,100
set xlabel 'time [s]' offset 0,0.3
side = 'energy [J]'; @SIDE
heap = stem.'_heap.csv'
set label 90 'one pile of 27' at screen 0.56,0.325 center
set label 1 'damping takes: cubes' at first 0.35,156 left
set label 2 'bricks' at first 0.75,78 left
set label 3 'pushes add: bricks' at first 1.5,56 left
set label 4 'cubes' at first 2.5,24 left
plot heap using 'time_s':'cubes_damping_J' with lines lt 1, \
  '' using 'time_s':'cubes_pushes_J' with lines lt 3, \
  '' using 'time_s':'bricks_damping_J' with lines lt 2, \
  '' using 'time_s':'bricks_pushes_J' with lines lt 4
