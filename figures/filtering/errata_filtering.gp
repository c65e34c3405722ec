# Means of the components of quaternions beside means of rotation vectors.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
flip = stem.'_flip.csv'
set key at screen 0.56,0.995 center top vertical maxcols 1

set tmargin at screen 0.885; set bmargin at screen 0.545
set xlabel 'frame; from 1 on the stored sign is the other one' offset 0,0.3
set xrange [-8.4:8.4]; set xtics -8,2
set yrange [-42:42]; set ytics -40,20
side = 'angle shown [°]'; @SIDE
set arrow 1 from first 0.5,graph 0 to first 0.5,graph 1 nohead lt 8 dt (6,4)
plot flip using 'frame':'computed_deg' with lines lt 8 title 'computed', \
  '' using 'frame':'components_deg' with linespoints lt 2 title 'mean of components', \
  '' using 'frame':'tangent_deg' with points lt 1 ps 1 title 'mean of rotation vectors'
unset arrow 1

set tmargin at screen 0.44; set bmargin at screen 0.1
unset key
set xlabel 'speed of the body [rad/s]' offset 0,0.3
set logscale xy; set format y powers; set format x '%g'
set xrange [0.1:60]; set xtics (0.1, 0.3, 1, 3, 10, 30)
set yrange [1e-17:200]; set ytics 1e-16,1e4
side = 'angle to the right mean [rad]'; @SIDE
set label 1 'the sign changes in the window' at 0.13,3 left textcolor lt 2
set label 2 'one sign, the body stops' at 2.6,1e-8 left textcolor lt 3
set label 3 'rotation vectors' at 0.13,3e-14 left textcolor lt 1
plot stem.'.csv' using 'speed_rad_s':'components' with lines lt 2, \
  '' using 'speed_rad_s':'aligned' with lines lt 3, \
  '' using 'speed_rad_s':'tangent' with lines lt 1
