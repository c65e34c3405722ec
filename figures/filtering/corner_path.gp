# Where the cube is, and the path of one of its corners: computed, and under five filters.
tall = 1270
@PAGE
set multiplot
stats stem.'_frame.csv' using 'left_mm' name 'left' nooutput
stats stem.'_frame.csv' using 'right_mm' name 'right' nooutput
stats stem.'_frame.csv' using 'bottom_mm' name 'bottom' nooutput
stats stem.'_frame.csv' using 'top_mm' name 'top' nooutput
set origin 0,0.76; set size 1,0.24
load stem.'_clump.gp'
unset object; unset arrow; unset label
unset border; unset tics; unset grid; unset key
set origin 0,0; set size noratio 1,1
set lmargin at screen 0.03; set rmargin at screen 0.97
# A millimetre is as long upwards as sideways.
panel = 0.098
long = right_max - left_min
air = 0.02*long
long = long + 2*air
high = long*panel*tall/(0.94*wide)
middle = (bottom_min + top_max)/2
set xrange [left_min - air:left_min - air + long]
set yrange [middle - high/2:middle + high/2]
bar = 5.0
names = 'computed "box filter, 5 frames" "box filter, 15 frames" "envelope of 1 cm and 1°: arc of 1 cm around the start" "soft envelope" "one-euro filter"'
columns = 'computed box5 box15 envelope soft one_euro'
do for [k=1:6] {
  set tmargin at screen 0.735 - 0.122*(k - 1)
  set bmargin at screen 0.735 - 0.122*(k - 1) - panel
  set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb '#f4f4f4' fs solid noborder behind
  set label 1 word(names,k) at graph 0.004,1.09 left textcolor rgb '#202020'
  if (k == 1) {
    set arrow 1 from graph 0.985,1.09 rto first -bar,0 nohead lc rgb '#202020' lw 3 front
    set label 2 sprintf('%g mm ',bar) at first right_max + air - 0.015*long - bar,graph 1.09 right textcolor rgb '#202020'
  }
  along = word(columns,k).'_along_mm'
  across = word(columns,k).'_across_mm'
  path = "stem.'.csv' using along:across with lines lw 1 dt 1 lc rgb '#56B4E9', '' using along:across with points pt 7 ps 0.35 lc rgb '#0072B2', '' using along:across every ::0::0 with points pt 6 ps 1.1 lw 2 lc rgb '#D55E00'"
  circle = "stem.'_frame.csv' using 'circle_along_mm':'circle_across_mm':'radius_mm' with circles fs empty border lc rgb '#808080' lw 1.5, "
  eval 'plot '.(k == 4 ? circle : '').path
  unset arrow 1; unset label 2
}
