# Work against error, with exact impact times and with time stepping; the ratio against the number of cubes.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale xy

set key at screen 0.56,0.985 center top vertical maxcols 2
set tmargin at screen 0.90; set bmargin at screen 0.54
set format x powers; set format y powers
set xlabel 'largest error of a height [m]' offset 0,0.3
side = 'work of ten cubes'; @SIDE
set xrange [*:*] reverse
set arrow 1 from 0.01,graph 0 to 0.01,graph 1 nohead lt 8 dt (6,4)
set label 1 'accepted' at 0.01,graph 0.06 left offset 0.7,0 textcolor rgb soft
plot stem.'.csv' using (column('exact') == 1 ? column('error_m') : NaN):'work' with points lt 1 ps 1.2 title 'exact impact times', \
  '' using (column('exact') == 0 ? column('error_m') : NaN):'work' with points lt 2 ps 1.2 title 'time stepping'

unset key; unset label 1; unset arrow 1
set tmargin at screen 0.42; set bmargin at screen 0.105
set format x '%g'; set format y '%g'
set xlabel 'cubes that bounce side by side'
set xrange [0.9:80] noreverse
set xtics (1,2,4,8,16,32,64)
set yrange [0.05:5]
side = 'exact over stepping'; @SIDE
set arrow 2 from graph 0,first 1 to graph 1,first 1 nohead lt 8 dt (2,4)
set label 2 'refuted below' at 1,1 offset 0,-0.7 textcolor rgb soft
set arrow 3 from graph 0,first 2 to graph 1,first 2 nohead lt 8 dt (2,4)
set label 3 'confirmed above' at 1,2 offset 0,0.7 textcolor rgb soft
plot stem.'_cubes.csv' using 'cubes':'ratio' with linespoints lt 1
