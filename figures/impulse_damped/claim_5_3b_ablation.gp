# Boxes that chatter and mean time to rest, with parts of the damping, sorted by chatter; bars: 95 % over seeds.
tall = 620
@PAGE
set multiplot
label(n) = n == 1 ? 'scaling only' : n == 2 ? 'scaling+alignment' : n == 3 ? 'all parts' \
  : n == 4 ? 'no scaling' : n == 5 ? 'no slow parts' : n == 6 ? 'no settling' \
  : n == 7 ? 'no turning' : 'no undoing'
set style fill solid 1.0 border lc rgb '#ffffff'
set yrange [7.6:-0.6]
set border 2 lc rgb '#808080'; unset grid
set grid x lc rgb '#dddddd' lw 0.7 dt 1
set tmargin at screen 0.90; set bmargin at screen 0.15
unset key
set lmargin at screen 0.34; set rmargin at screen 0.64
set xrange [0:110]; set xtics 0,40
set ytics scale 0
set label 1 'boxes that chatter' at screen 0.48,0.945 center
set label 2 'time to rest' at screen 0.825,0.945 center
set xlabel 'boxes [%]' offset 0,0.2
plot stem.'.csv' using (50*column('chatter')):0:(50*column('chatter')):(0.35):yticlabels(label(column('set'))) with boxxyerror lc rgb '#0072B2', \
  '' using (100*column('chatter')):0:(100*column('chatter_low')):(100*column('chatter_high')) with xerrorbars pt -1 lw 1.5 lc rgb '#202020', \
  '' using (100*column('chatter_high')):0:(sprintf('%.0f', 100*column('chatter'))) with labels left offset 0.7,0
unset label 1; unset label 2
set lmargin at screen 0.70; set rmargin at screen 0.955
set xrange [0:3.6]; set xtics 0,1
set format y ''
set xlabel 'time [s]' offset 0,0.2
plot stem.'.csv' using (0.5*column('rest_s')):0:(0.5*column('rest_s')):(0.35) with boxxyerror lc rgb '#D55E00', \
  '' using 'rest_s':0:'rest_low_s':'rest_high_s' with xerrorbars pt -1 lw 1.5 lc rgb '#202020', \
  '' using 'rest_high_s':0:(sprintf('%.1f', column('rest_s'))) with labels left offset 0.5,0
