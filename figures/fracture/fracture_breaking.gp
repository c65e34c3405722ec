# The load that breaks a plank over the beam's, and the drop that breaks it.
tall = 640
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.95; set bmargin at screen 0.62
set xrange [0.5:4.5]; set xtics 1; set yrange [0:4]; set ytics 1
set xlabel 'cells through the thickness' offset 0,0.4
side = 'load, over the beam''s'; @SIDE
plot stem.'.csv' using 'cells':'load' with linespoints lt 1 notitle, 1 with lines lt 8 notitle
set tmargin at screen 0.40; set bmargin at screen 0.13
set logscale xy; set xrange [50:1200]; set xtics (60, 120, 240, 480, 960); set yrange [0.01:10]; set ytics 10; set format y '%g'
set xlabel 'steps per second' offset 0,0.4
side = 'drop that breaks it [m/s]'; @SIDE
set key at screen 0.56,0.47 center top vertical maxrows 1 samplen 2
plot stem.'_speeds.csv' using 'steps_per_second':'row_m_s' with linespoints lt 2 title 'glued boxes', \
  '' using 'steps_per_second':'elements_m_s' with lines lt 1 title 'elements, at any step'
