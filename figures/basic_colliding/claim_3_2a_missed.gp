# Share of collisions that a test at the end of each step finds, against the speed.
tall = 940
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale x 2
set xrange [0.11:18]
set yrange [0:1.06]; set ytics 0,0.25
set arrow 1 from 4,graph 0 to 4,graph 1 nohead lt 8 dt (6,4)
set arrow 2 from graph 0,first 1 to graph 1,first 1 nohead lt 8

set tmargin at screen 0.885; set bmargin at screen 0.53
set format x ''
side = 'fraction found'; @SIDE
set label 1 'decides' at 4,0.07 right offset -0.7,0 textcolor rgb soft
set label 2 'confirmed below 0.9' at graph 0.02,first 0.9 offset 0,-0.7 textcolor rgb soft
set arrow 3 from graph 0,first 0.9 to graph 1,first 0.9 nohead lt 8 dt (2,4)
set key at screen 0.56,0.985 center top vertical maxcols 1
plot stem.'.csv' using 'speed':'half_size' with linespoints lt 3 title 'small cube of half the thickness', \
  '' using 'speed':'found' with linespoints lt 1 title 'small cube', \
  '' using 'speed':'found':'low':'high' with yerrorbars lt 1 notitle, \
  '' using 'speed':'double_size' with linespoints lt 2 title 'small cube of twice the thickness'
unset label 1; unset label 2; unset arrow 3

set tmargin at screen 0.405; set bmargin at screen 0.10
set format x '%g'
set xtics ('1/8' 0.125, '1/4' 0.25, '1/2' 0.5, '1' 1, '2' 2, '4' 4, '8' 8, '16' 16)
set xlabel 'thicknesses per step'
set label 99 side
set key at screen 0.56,0.515 center top vertical maxcols 2
plot stem.'.csv' using 'speed':'others' with linespoints lt 5 title 'deeper', \
  '' using 'speed':'brushes' with linespoints lt 4 title 'brushes', \
  '' using 'speed':'found' with linespoints lt 1 title 'all', \
  '' using 'speed':(column('length') < 0.7 ? column('length') : NaN) with points pt 6 ps 2 lc rgb '#303030' title 'closed form'
