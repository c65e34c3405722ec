# Depth against time of cubes at rest.
tall = 700
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.93
set tmargin at screen 0.75; set bmargin at screen 0.15
set logscale xy; set format y powers; set ytics 1e-15,1000; set ytics add ('none' 1e-17); set yrange [1e-18:1e4]; set xrange [1:*]
set xlabel 'time [s]'
side = 'depth [m]'; @SIDE
set key at screen 0.55,0.985 center top vertical maxcols 1
# No depth at all lies on a line of its own.
depth(name) = column(name) > 1e-17 ? column(name) : 1e-17
plot stem.'.csv' using 'time_s':(depth('zeroed_m')) every 3 with points lt 4 pt 12 ps 1.6 lw 1.5 title 'stack, negative forces set to 0', \
  '' using 'time_s':(depth('left_m')) with lines lt 1 title 'stack, negative forces left', \
  '' using 'time_s':'light_m' with lines lt 2 title 'load below the tolerance', \
  '' using 'time_s':(depth('relative_m')) with lines lt 3 title 'stack, library''s solver', \
  1e-9*x**2 with lines lt 8 dt (2,4) title 'slope 2'
