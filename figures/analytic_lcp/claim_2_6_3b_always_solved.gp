# How the errors of the answers are distributed.
tall = 520
@PAGE
numbers = stem.'.csv'
set lmargin at screen 0.19; set rmargin at screen 0.95
set tmargin at screen 0.84; set bmargin at screen 0.18
set xrange [-16.5:-5.5]
set yrange [0:100]
set xtics -16,2
set format x '10^{%g}'
set xlabel 'error of the velocities, up to'
side = 'fraction of the problems [%]'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 2 width -1
set label 1 "beyond 10^{-7}:\nnot solved" at first -9.5,60 textcolor rgb soft
set arrow 1 from first -6.5,0 to first -6.5,100 nohead lt 8
plot numbers using 'power':'points_percent' with linespoints lt 1 title 'random points', \
  '' using 'power':'bricks_percent' with linespoints lt 2 title 'three cubes', \
  '' using 'power':'rods_percent' with linespoints lt 3 title 'Painlevé’s rod'
