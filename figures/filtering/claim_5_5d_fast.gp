# A tossed cube under three filters, and bodies of constant speed.
tall = 1360
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:1.6]; set xtics 0,0.4
set tmargin at screen 0.92; set bmargin at screen 0.765
side = 'move [envelopes]'; @SIDE
set yrange [0:*]; set ytics 0,1
set label 1 'a tossed cube: its move in a frame' at graph 0.02,1.09 left textcolor rgb '#202020'
set label 2 'fast above this line' at graph 0.985,first 1.3 right textcolor rgb soft
set key at screen 0.56,0.995 center top horizontal
plot stem.'.csv' using 'time_s':'move' with lines lt 8 lw 2 notitle, \
  1 with lines lt 8 dt (6,4) notitle, \
  NaN with linespoints lt 1 title 'envelope', NaN with linespoints lt 2 title 'soft', \
  NaN with linespoints lt 3 title 'one-euro'
unset key; unset label 2

set tmargin at screen 0.69; set bmargin at screen 0.535
side = 'off by [mm]'; @SIDE
set logscale y; set yrange [0.003:60]; set ytics ('none' 0.003, '0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
on(p) = p > 0.003 ? p : 0.003
set label 1 'from where it is shown to where it is'
set xlabel 'time [s]' offset 0,0.3
plot stem.'.csv' using 'time_s':(on(column('thesis_mm'))) with lines lt 1, \
  '' using 'time_s':(on(column('soft_mm'))) with lines lt 2, \
  '' using 'time_s':(on(column('euro_mm'))) with lines lt 3
unset logscale y

set xrange [0:2]; set xtics 0,0.5
unset xlabel
set tmargin at screen 0.43; set bmargin at screen 0.27
side = 'frames as computed'; @SIDE
set yrange [-0.04:1.06]; set ytics 0,0.25
set label 1 'a body at constant speed'
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lt 8 dt (6,4) back
plot stem.'_speeds.csv' using 'speed':'thesis_exact' with points lt 1 ps 0.7, \
  '' using 'speed':'soft_exact' with points lt 2 ps 0.5, \
  '' using 'speed':'euro_exact' with points lt 3 ps 0.5

set tmargin at screen 0.23; set bmargin at screen 0.07
side = 'off by at most [mm]'; @SIDE
unset label 1
set yrange [-0.4:10.6]; set ytics 0,5
set xlabel 'distance in a frame [radius of the envelope]' offset 0,0.3
plot stem.'_speeds.csv' using 'speed':'thesis_offset_mm' with points lt 1 ps 0.7, \
  '' using 'speed':'soft_offset_mm' with points lt 2 ps 0.5, \
  '' using 'speed':'euro_offset_mm' with points lt 3 ps 0.5
