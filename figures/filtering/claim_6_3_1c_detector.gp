# Rules that detect chatter from earlier frames: curves, kinds of motion, windows.
tall = 1440
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955

# No false alarm at all lies on the left edge.
least = 7e-4
on(a) = a > least ? a : least
set logscale x; set xrange [least:1.15]
set xtics ('none' least, '0.01' 0.01, '0.1' 0.1, '1' 1)
set yrange [0:1.03]; set ytics 0,0.2
set tmargin at screen 0.905; set bmargin at screen 0.655
side = 'chatter detected'; @SIDE
set xlabel 'false alarms: motion classified as chatter' offset 0,0.3
set key at screen 0.56,0.995 center top horizontal maxcols 2
set label 1 'sleeping rule' at 0.026,0.05 right textcolor rgb soft
set label 2 'damping' at 0.6,0.9 center textcolor rgb soft
# A curve ends where other conditions of its rule let nothing more through.
curve(t, hits) = t == 0 ? NaN : hits
point(r, k, hits) = r == k ? hits : NaN
plot stem.'.csv' using (on(column('alarms'))):(curve(column('threshold'), column('hits'))) with lines lt 1 title 'the rule', \
  stem.'_path.csv' using (on(column('alarms'))):(curve(column('threshold'), column('hits'))) with lines lt 2 title 'path over distance', \
  stem.'_speed.csv' using (on(column('alarms'))):'hits' with lines lt 3 title 'speed', \
  NaN with points lt 8 pt 7 ps 1.2 title 'standard numbers', \
  for [k=1:4] stem.'_points.csv' using (on(column('alarms'))):(point(column('rule'), k, column('hits'))) with points lt k pt 7 ps 1.2 notitle
unset label 1; unset label 2
unset logscale x

set tmargin at screen 0.545; set bmargin at screen 0.335
set xrange [-0.03:1.04]; set xtics 0,0.2
set yrange [7.6:0.4]
set ytics ('chatters' 1, 'slides' 2, 'creeps' 3, 'rolls' 4, 'rocks' 5, 'falls' 6, 'slides fast' 7)
unset label 99
set lmargin at screen 0.22
set xlabel 'fraction classified as chatter, or as slow' offset 0,0.3
place(kind) = kind == 5 ? 3 : kind == 3 ? 4 : kind == 4 ? 5 : kind
set key at screen 0.58,0.592 center top horizontal maxcols 4
plot stem.'_kinds.csv' using 'rule':(place(column('kind')) - 0.24) with points lt 1 ps 0.9 title 'rule', \
  '' using 'path':(place(column('kind')) - 0.08) with points lt 2 ps 0.9 title 'path', \
  '' using 'slow':(place(column('kind')) + 0.08) with points lt 3 ps 0.9 title 'sleeping', \
  '' using 'small':(place(column('kind')) + 0.24) with points lt 4 ps 0.9 title 'damping'

set lmargin at screen 0.17
set tmargin at screen 0.24; set bmargin at screen 0.06
set logscale x 2; set xrange [7.3:66]; set xtics (8, 12, 16, 20, 24, 30, 45, 60)
set yrange [0.81:1.015]; set ytics 0.85,0.05
side = 'classified correctly'; @SIDE
set xlabel 'frames in the window' offset 0,0.3
set key at screen 0.56,0.27 center top horizontal maxcols 2
set label 1 'nineteen of twenty' at graph 0.985,first 0.925 right textcolor rgb soft
plot stem.'_windows.csv' using 'frames':'hits' with linespoints lt 1 title 'chatter', \
  '' using 'frames':'kept' with linespoints lt 2 title 'motion', \
  0.95 with lines lt 8 dt (6,4) notitle
