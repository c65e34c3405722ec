# The contact area of a turned cube: three of its polygons, the area, its error.
tall = 780
@PAGE
set multiplot
outlines = stem.'_polygons.csv'
stats stem.'.csv' using 'points' name 'rows' nooutput
few = rows_records > 40 ? 3 : 1
corner(angle, what) = column('angle_deg') == angle && column('outline') == what ? column('x_m') : NaN

# Three views from above, scaled to the cube.
stats outlines using (abs(column('x_m'))) name 'reach' nooutput
r = 1.1*reach_max
unset border; unset grid
set tics scale 0; set format ''
set size ratio -1
set xrange [-r:r]; set yrange [-r:r]
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
unset key
angles = '0 15 45'
do for [view=1:3] {
  angle = real(word(angles, view))
  set origin 0.03 + 0.32*(view - 1),0.71
  set size 0.30,0.23
  set label 1 sprintf('θ = %g°', angle) at graph 0.5,1.12 center textcolor rgb '#202020'
  plot outlines using (corner(angle, 2)):'z_m' with filledcurves closed lc rgb '#F0E442', \
    '' using (corner(angle, 0)):'z_m' with lines lt 1, \
    '' using (corner(angle, 1)):'z_m' with lines lt 2
}
unset label 1

set size noratio
@AXES
set lmargin at screen 0.18; set rmargin at screen 0.95
set xrange [0:90]; set xtics 15
set yrange [0.8:1.0]; set ytics 0.05

set key at screen 0.565,0.695 center top horizontal maxcols 2
set tmargin at screen 0.63; set bmargin at screen 0.36
side = 'area / size²'; @SIDE
set format x ''; set format y '%g'
plot stem.'.csv' using 'angle_deg':'exact' with lines lt 1 title 'closed form', \
  '' using 'angle_deg':'area' every few with points lt 2 title 'from the contact points'

unset key
set tmargin at screen 0.31; set bmargin at screen 0.12
set format x '%g°'
set xlabel 'angle of the upper cube θ'
side = 'error / size²'; @SIDE
set logscale y
set yrange [1e-17:1e-10]; set ytics 1e-16,1e2
set format y powers
set ytics add ('0' 1e-17)
set label 'accepted' at 89,2e-12 right offset 0,0.7 textcolor rgb soft
plot stem.'.csv' using 'angle_deg':(column('error') > 0 ? column('error') : 1e-17) every few with points lt 2, \
  '' using 'angle_deg':'accepted' with lines lt 8
