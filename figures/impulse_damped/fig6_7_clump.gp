# Cubes that fly together and settle, coloured by their chatter, with a bar of these colours.
tall = 960
@PAGE
set multiplot
bar = stem.'_bar.csv'
stats bar using 'chatter_mm' name 'shade' nooutput
set label 1 'start' at screen 0.04,0.975 left textcolor rgb '#202020'
set origin 0,0.595; set size 1,0.396
load stem.'_start.gp'
set label 1 'settled' at screen 0.04,0.575
set origin 0,0.19; set size 1,0.354
load stem.'_settled.gp'
unset label; unset object; unset arrow
@AXES
unset key; unset grid
set origin 0,0; set size noratio 1,1
set lmargin at screen 0.08; set rmargin at screen 0.92
set tmargin at screen 0.155; set bmargin at screen 0.115
set border 15 lc rgb '#808080'
unset ytics; set yrange [0:1]
set logscale x
set xrange [shade_min:shade_max]
set xtics ('0.001' shade_min, '0.01' 1e-2, '0.1' 1e-1, '1' 1, '10' 10, '100' shade_max) scale 0.6 nomirror
set format x '%g'
set xlabel 'chatter within half a second [mm]; dark grey: still moves'
step = (shade_max/shade_min)**(0.5/(shade_records - 1))
plot bar using 'chatter_mm':(0.5):(column('chatter_mm')/step):(column('chatter_mm')*step*1.02):(0):(1):'colour' \
  with boxxyerror fs solid 1.0 noborder lc rgb variable
