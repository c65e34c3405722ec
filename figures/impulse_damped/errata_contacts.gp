# Errata of collisions and contacts, one in each row: a square for the text taken literally, a circle
# for the same number mended. What is too small for the axis is in the column of 0.
# The numbers themselves stand beside it.
array what[25] = [ \
  "D1  two orders [m]", "D2  distance in 1 s [m]", "D3  first slide [m]", "D4  not stable [steps]", \
  "D5  height after fall [m]", "D6  speed at rest [m/s]", \
  "C1  hop at rest [m]", "C2  speed at rest [m/s]", "C3  same, stable [m/s]", \
  "C4  rebound [m/s]", "C5  tilt after a hit [rad]", "C6  same as C3 [m/s]", \
  "C7  parting [m/s]", "C8  flat landing [rad/s]", "C9  approach left [m/s]", \
  "C10  slide left [m/s]", "C11  energy ratio [-]", \
  "RK1  sag of a stack [m]", "RK2  creep at rest [m/s]", "RK3  speed at rest [m/s]", \
  "RK4  unrest, stack [m/s]", \
  "RC1  rebound [m/s]", "RC2  hit from afar [m/s]", "RC3  asymmetry [m/s]", "RC4  turn in air [rad]" ]
rows = 25
tall = 130 + 40*rows
@PAGE
zero = 1e-10     # where 0 is drawn
least = 1e-9     # what is smaller counts as 0
shown(x) = x < least ? zero : x
text(x) = x < least ? '0' : x < 1e-3 ? sprintf('%.0e',x) : sprintf('%.2g',x)
set lmargin at screen 0.445; set rmargin at screen 0.975
set tmargin at screen 1-75.0/tall; set bmargin at screen 55.0/tall
set logscale x
set xrange [2.5e-11:1e11]  # the numbers stand on the right
set yrange [rows-0.4:-0.6]
set xtics ('0' zero, '10^{-8}' 1e-8, '10^{-4}' 1e-4, '1' 1)
unset ytics
set grid x noy lc rgb '#dddddd' lw 0.7 dt 1
unset border
set arrow from zero/3,graph 0 to 60,graph 0 nohead lc rgb '#808080' lw 1
set arrow 1 from 1e-9,graph 0 to 1e-9,graph 1 nohead lc rgb '#808080' lw 1 dt (3,3)
do for [k=1:rows] {
  set label k what[k] at screen 0.02,first k-1 left textcolor rgb '#202020'
}
# A line below each listing's rows.
do for [after in "5.5 16.5 20.5"] {
  set arrow from screen 0.02,first (after+0) to screen 0.98,first (after+0) nohead lc rgb '#b0b0b0' lw 1
}
set key at screen 0.02,1-14.0/tall left top horizontal reverse Left samplen 1 width 2 maxrows 1
set label 90 'literal' at 1e2,screen 1-54.0/tall left textcolor rgb '#D55E00'
set label 91 'corrected' at 1.3e6,screen 1-54.0/tall left textcolor rgb '#0072B2'
plot stem.'.csv' using (shown(column('failure'))):'row':(shown(column('mended'))-shown(column('failure'))):(0) with vectors nohead lc rgb '#b0b0b0' lw 2 notitle, \
  '' using (shown(column('failure'))):'row' with points lt 2 ps 1.5 title 'taken literally', \
  '' using (shown(column('mended'))):'row' with points lt 1 ps 1.3 title 'corrected', \
  '' using (1e2):'row':(text(column('failure'))) with labels left textcolor rgb '#B34A00' notitle, \
  '' using (5e6):'row':(text(column('mended'))) with labels left textcolor rgb '#0060A0' notitle
