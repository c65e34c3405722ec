# Impulses per second against the height of a stack that impulses alone hold up.
tall = 620
@PAGE
set lmargin at screen 0.19; set rmargin at screen 0.95
set tmargin at screen 0.86; set bmargin at screen 0.15
numbers = stem.'.csv'
stats numbers using 'cubes' name 'cubes' nooutput
stats numbers using (column('long_capped') + column('short_capped')) name 'capped' nooutput
set logscale xy
set xrange [0.9:1.12*cubes_max]
set yrange [500:*]
set xtics (1,2,4,8,16,32)
set format y powers
set ytics 1e-15,10
set xlabel 'cubes in the stack'
side = 'impulses per second'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 2 width -1
# A frame around means of which a run was cut short.
frames = "numbers using 'cubes':(column('long_capped') > 0 ? column('long_per_s') : NaN) with points pt 4 ps 2.2 lw 2 lc rgb '#000000' notitle, ".\
  "numbers using 'cubes':(column('short_capped') > 0 ? column('short_per_s') : NaN) with points pt 4 ps 2.2 lw 2 lc rgb '#000000' notitle,"
if (capped_max == 0) { frames = '' } else { set label 1 'framed: reached the limit' at graph 0.02,0.95 textcolor rgb soft }
plot @frames numbers using 'cubes':'short_square_per_s' with lines lt 8 title 'as height squared', \
  '' using 'cubes':'long_square_per_s' with lines lt 8 notitle, \
  '' using 'cubes':'short_linear_per_s' with lines lt 8 dt (3,3) title 'as height', \
  '' using 'cubes':'long_linear_per_s' with lines lt 8 dt (3,3) notitle, \
  '' using 'cubes':'short_per_s' with points lt 2 ps 1.3 title 'hops of 0.1 ms', \
  '' using 'cubes':'long_per_s' with points lt 1 ps 1.3 title 'hops of 1 ms'
