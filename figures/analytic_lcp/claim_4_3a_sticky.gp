# Collisions until rest against the threshold below which they stick.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale x
set xrange [7e-4:1]
set format x ''
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.87; set bmargin at screen 0.49
set yrange [0:*]
side = 'collisions until rest'; @SIDE
set arrow 1 from 0.05,graph 0 to 0.05,graph 1 nohead lt 8 dt (6,4)
set label 1 'default' at 0.05,graph 0.93 right offset -0.7,0 textcolor rgb soft
plot stem.'.csv' using 'threshold':'collisions' with linespoints lt 2 title 'thrown dice, mean', \
  stem.'_flat.csv' using 'threshold':'collisions' with points lt 1 ps 1.2 title 'flat drop', \
  '' using 'threshold':'exact' with lines lt 8 title 'closed form'

unset key; unset label 1
set tmargin at screen 0.45; set bmargin at screen 0.105
set format x powers
set xlabel 'threshold, over sqrt(g L)'
set logscale y; set format y powers
set autoscale y
set yrange [1e-3:1]
side = 'change at rest [m]'; @SIDE
plot stem.'.csv' using 'threshold':(column('moved_m') > 0 ? column('moved_m') : NaN) with linespoints lt 2
