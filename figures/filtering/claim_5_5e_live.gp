# A cube that lands and a body that creeps, as computed and as seen live; frames of delay by filter.
tall = 1240
@PAGE
set multiplot
set lmargin at screen 0.165; set rmargin at screen 0.955
landing = stem.'_landing.csv'
creep = stem.'_creep.csv'

set tmargin at screen 0.925; set bmargin at screen 0.65
set xrange [-8.4:8.4]; set xtics -8,4
set yrange [-0.02:0.62]; set ytics 0,0.2
set xlabel 'frames after the landing' offset 0,0.3
side = 'height [m]'; @SIDE
set label 1 'a cube lands' at graph 0.98,0.9 right textcolor rgb '#202020'
set key at screen 0.56,0.995 center top vertical maxrows 3 width 1
plot landing using 'frame':'computed_m' with lines lt 8 lw 3 title 'computed', \
  '' using 'frame':'box_m' with lines lt 1 dt 1 title 'box, five frames', \
  '' using 'frame':'causal_m' with points lt 1 pt 6 ps 0.9 title 'the same, causal', \
  '' using 'frame':'envelope_m' with points lt 2 title 'envelope', \
  '' using 'frame':'soft_m' with points lt 3 pt 8 ps 1.2 title 'soft envelope', \
  '' using 'frame':'one_euro_m' with linespoints lt 4 ps 0.6 title 'one-euro'
unset key

set tmargin at screen 0.56; set bmargin at screen 0.365
set xrange [-0.5:30.5]; set xtics 0,10
set yrange [-10:41]; set ytics 0,20
set xlabel 'frames' offset 0,0.3
side = 'distance [mm]'; @SIDE
set label 1 'a body creeps' at graph 0.03,0.88 left textcolor rgb '#202020'
plot creep using 'frame':(1e3*column('computed_m')) with lines lt 8 lw 3, \
  '' using 'frame':(1e3*column('box_m')) with lines lt 1 dt 1, \
  '' using 'frame':(1e3*column('causal_m')) with points lt 1 pt 6 ps 0.9, \
  '' using 'frame':(1e3*column('envelope_m')) with steps lt 2 dt 1, \
  '' using 'frame':(1e3*column('envelope_m')) with points lt 2, \
  '' using 'frame':(1e3*column('soft_m')) with lines lt 3, \
  '' using 'frame':(1e3*column('one_euro_m')) with lines lt 4

set tmargin at screen 0.24; set bmargin at screen 0.075
unset label 1
set style fill solid 1.0 noborder
set xrange [0.5:5.5]
set xtics ('box' 1, "causal\nbox" 2, 'envelope' 3, "soft\nenvelope" 4, 'one-euro' 5) scale 0
unset xlabel
set yrange [0:8.2]; set ytics 0,2
side = 'frames late'; @SIDE
set key at screen 0.56,0.295 center top vertical maxrows 2 samplen 1.5
w = 0.2
small = form eq 'svg' ? ',14' : ',10'
set boxwidth w
what = 'held_back fast landing slow'
text(x) = sprintf(x < 1 ? '%.1g' : '%.2g', x)
at(k) = column('filter') + (k - 1.5)*w
plot stem.'.csv' using (at(0)):'held_back' with boxes dt 1 lc rgb '#4D4D4D' title 'frames that wait', \
  '' using (at(1)):'fast' with boxes dt 1 lc rgb '#56B4E9' title 'a fast body', \
  '' using (at(2)):'landing' with boxes dt 1 lc rgb '#0072B2' title 'a landing', \
  '' using (at(3)):'slow' with boxes dt 1 lc rgb '#E69F00' title 'a body that creeps', \
  for [k = 0:3] '' using (at(k)):(column(word(what, k + 1))):(text(column(word(what, k + 1)))) with labels font small offset 0,0.5 notitle
