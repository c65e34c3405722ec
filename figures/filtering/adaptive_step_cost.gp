# Chatter and time to rest against work, fixed and adaptive steps; a cube thrown at a thin plank.
tall = 1240
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
adaptive = stem.'_adaptive.csv'
plank = stem.'_plank.csv'

set key at screen 0.56,0.985 center top horizontal
set tmargin at screen 0.935; set bmargin at screen 0.69
set logscale x 2
set xrange [0.55:32]; set xtics (1, 2, 4, 8, 16, 32)
set yrange [0:2.3]; set ytics 0,0.5
side = 'amplitude at rest [mm]'; @SIDE
plot stem.'.csv' using 'work':'chatter_mm' with linespoints lt 1 title 'fixed steps', \
  '' using 'work':'chatter_mm':(sprintf('1/%.0f s', 1/column('step_s'))) with labels right offset -0.6,0.6 textcolor rgb '#0072B2' notitle, \
  adaptive using 'work':'chatter_mm' with points lt 2 ps 1.2 title 'adaptive, by tolerance', \
  '' using 'work':'chatter_mm':(sprintf('%g mm', column('tolerance_mm'))) with labels left offset 0.9,-0.3 textcolor rgb '#B04A00' notitle
unset key

set tmargin at screen 0.65; set bmargin at screen 0.43
set yrange [0:7]; set ytics 0,2
side = 'time to rest [s]'; @SIDE
set xlabel 'work: pair tests over those at 1/60 s' offset 0,0.3
plot stem.'.csv' using 'work':'rest_s' with linespoints lt 1, \
  adaptive using 'work':'rest_s' with points lt 2 ps 1.2

set tmargin at screen 0.315; set bmargin at screen 0.08
set xrange [3.4:76]; set xtics (4, 8, 16, 32, 64)
set yrange [-0.04:1]; set ytics 0,0.25
side = 'pass the plank'; @SIDE
set label 1 'a cube of 0.2 m thrown at a plank of 0.05 m' at graph 0.5,1.09 center textcolor rgb '#202020'
set xlabel 'speed [m/s]' offset 0,0.3
plot plank using 'speed_m_s':'fixed' with linespoints lt 1, \
  '' using 'speed_m_s':'adaptive' with linespoints lt 2
