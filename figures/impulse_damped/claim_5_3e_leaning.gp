# Boxes that chatter under the scaling of velocities: how far from level, and how much they shake.
tall = 560
@PAGE
stats stem.'.csv' using (column('limit_deg')) name 'limit' nooutput
limit = limit_max
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.84; set bmargin at screen 0.17
set logscale x
set xrange [1e-4:60]; set format x powers
set logscale y
set yrange [0.08:6]
set ytics (0.1, 1, 10)
set xlabel 'tilt from a level face [°]'
side = 'shake, over free fall'; @SIDE
set key at screen 0.56,0.985 center top vertical maxcols 1
set arrow 1 from limit,graph 0 to limit,graph 1 nohead lt 8 dt (6,4)
set label 1 'caught' at limit,graph 0.95 right offset -0.8,0 textcolor rgb soft
set label 2 'missed' at limit,graph 0.95 left offset 0.8,0 textcolor rgb soft
low(x) = x > 1e-4 ? x : 1.2e-4
plot stem.'.csv' using (column('leans') == 0 ? low(column('tilt_deg')) : NaN):'shake' with points lt 1 pt 6 ps 0.7 title 'a face lies on something', \
  '' using (column('leans') == 1 ? low(column('tilt_deg')) : NaN):'shake' with points lt 2 ps 1 title 'leans'
