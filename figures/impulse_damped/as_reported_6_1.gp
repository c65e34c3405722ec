# Figures 6.6 and 6.7 after ten seconds with two dampings: pictures, chatter of each seed, and what a viewer sees no fault in.
tall = 1640
@PAGE
set multiplot
set label 90 'our constants' at screen 0.25,0.987 center
set label 91 'as\_reported' at screen 0.75,0.987 center
do for [k=0:3] {
  set origin 0.5*(k % 2),0.829 - 0.162*(k / 2)
  set size 0.5,0.145
  load stem.'_'.word('shot_as_meant shot_as_reported clump_as_meant clump_as_reported', k + 1).'.gp'
}
unset label; unset object; unset arrow
@AXES
set origin 0,0; set size noratio 1,1
set lmargin at screen 0.08; set rmargin at screen 0.92
set tmargin at screen 0.650; set bmargin at screen 0.637
bar = stem.'_bar.csv'
stats bar using 'chatter_mm' name 'shade' nooutput
set border 15 lc rgb '#808080'
unset key; unset grid; unset ytics; set yrange [0:1]
set logscale x
set xrange [shade_min:shade_max]
set xtics ('0.001' shade_min, '0.01' 1e-2, '0.1' 1e-1, '1' 1, '10' 10, '100' shade_max) scale 0.6 nomirror
set xlabel 'chatter within half a second [mm]; dark grey: still moves' offset 0,0.3
step = (shade_max/shade_min)**(0.5/(shade_records - 1))
plot bar using 'chatter_mm':(0.5):(column('chatter_mm')/step):(column('chatter_mm')*step):(0):(1):'colour' \
  with boxxyerror fs solid 1.0 noborder lc rgb variable

unset logscale x
@AXES
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.560; set bmargin at screen 0.415
set key at screen 0.56,0.586 center top horizontal
set xlabel ''
set xrange [0.5:3.5]; set xtics ('our constants' 1, 'as\_reported' 2, 'contact\_damped' 3)
set yrange [0:*]; set ytics 0,10
side = 'chatter at the end [mm]'; @SIDE
plot stem.'.csv' using (column('arm')-0.08):(column('figure') < 6.65 ? column('chatter_mm') : NaN) with points lt 1 title 'figure 6.6', \
  '' using (column('arm')+0.08):(column('figure') > 6.65 ? column('chatter_mm') : NaN) with points lt 2 title 'figure 6.7'

set tmargin at screen 0.338; set bmargin at screen 0.189
set key at screen 0.56,0.385 center top vertical maxrows 2
set yrange [0:1.05]; set ytics 0,0.25
side = 'fraction of runs'; @SIDE
set boxwidth 0.18
set style fill solid 0.8
sayings = stem.'_sayings.csv'
plot sayings using (column('arm')-0.3):'overlap' with boxes lt 1 title 'no overlap', \
  '' using (column('arm')-0.1):'hanging' with boxes lt 2 title 'nothing hangs', \
  '' using (column('arm')+0.1):'energy' with boxes lt 3 title 'no gain of energy', \
  '' using (column('arm')+0.3):'shaking' with boxes lt 4 title 'little chatter'

# Over the range of the constants.
set tmargin at screen 0.122; set bmargin at screen 0.045
set key at screen 0.56,0.163 center top vertical maxrows 2
set xlabel 'power of the damping, k\_scale' offset 0,0.5
set xrange [0.9:4.1]; set xtics 1,1
set yrange [0:4.2]; set ytics 0,1
side = 'faults absent'; @SIDE
range = stem.'_range.csv'
plot for [e in '0.5 1 2'] range using (column('eps_scale') == e + 0 ? column('k_scale') : NaN):'sayings' \
  with linespoints lt (e > 1.5 ? 3 : e > 0.7 ? 1 : 2) title 'thresholds × '.e
