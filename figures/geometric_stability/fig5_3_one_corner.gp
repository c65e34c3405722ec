# A cube with one corner on another: in space, from above, and shifted further and further.
tall = 790
@PAGE
set multiplot
outlines = stem.'_outlines.csv'
stats stem.'_shifts.csv' using 'shift_m' name 'shift' nooutput
stats outlines using 'x_m':'z_m' name 'seen' nooutput
load stem.'_marked.gp'
height(points) = 1 - points*1.0/tall

set origin 0,height(280)
set size 0.5,270.0/tall
load stem.'_boxes.gp'
unset object

# The plane of contact, from above: x to the right, z towards the viewer.
part(which) = column('outline') == which ? column('x_m') : NaN
corner(carried) = column('carried') == carried ? column('x_m') : NaN
unset border; unset tics; unset grid; unset key
set size ratio -1
air = 0.12
mark = form eq 'svg' ? 1.2 : 1.8
set xrange [seen_min_x - air:seen_max_x + air]; set yrange [seen_max_y + air:seen_min_y - air]
set lmargin at screen 0.52; set rmargin at screen 0.98
set tmargin at screen height(34); set bmargin at screen height(280)
set style fill solid 1.0 noborder
plot outlines using (part(9)):'z_m' with filledcurves closed lc rgb '#F0E442', \
  '' using (part(1)):'z_m' with lines lt 1 lw 2.5, \
  '' using (part(0)):'z_m' with lines lt 5 dt 1 lw 2.5, \
  stem.'.csv' using (corner(1)):'z_m' with points pt 7 ps mark lc rgb '#56B4E9', \
  '' using (corner(0)):'z_m' with points pt 6 ps mark lw 2 lc rgb '#202020', \
  stem.'_points.csv' using 'x_m':'z_m' with points pt 2 ps 0.5*mark lw 2 lc rgb '#202020'
set size noratio

# What the marks mean.
set xrange [0:1]; set yrange [0:1] noreverse
set lmargin at screen 0.05; set rmargin at screen 0.98
set tmargin at screen height(284); set bmargin at screen height(374)
set key inside center center vertical maxrows 3 maxcols 2 samplen 1.5 width -2
plot NaN with lines lt 5 dt 1 lw 2.5 title 'top box', \
  NaN with lines lt 1 lw 2.5 title 'bottom box', \
  NaN with filledcurves lc rgb '#F0E442' title 'hull of contact points', \
  NaN with points pt 2 ps 0.5*mark lw 2 lc rgb '#202020' title 'contact point', \
  NaN with points pt 7 ps mark lc rgb '#56B4E9' title 'corner carried', \
  NaN with points pt 6 ps mark lw 2 lc rgb '#202020' title 'corner not carried'

verdict(stable) = stable ? 'stable' : 'not stable'
both = corners_stable == hull_stable ? verdict(hull_stable) : 'stable by one rule only'
set label 1 'top box: '.both at screen 0.75,height(14) center textcolor rgb '#202020'

@AXES
set xtics nomirror; set ytics nomirror 1
set yrange [0:*]
set lmargin at screen 0.15; set rmargin at screen 0.955
set tmargin at screen height(475); set bmargin at screen 95.0/tall
set xrange [0:shift_max]
set xlabel 'shift of the top cube along both axes [m]'
side = 'worst corner: m a / load'; @SIDE
set arrow 1 from shown,graph 0 to shown,graph 1 nohead lt 8
set label 5 'shown above' at shown,graph 0.4 right offset -0.6,0 textcolor rgb soft
set key at screen 0.55,height(400) center top vertical maxrows 2 maxcols 1 width 0 samplen 3
plot stem.'_shifts.csv' using 'shift_m':'loaded' with lines lt 2 title 'the worst load on its top', \
  '' using 'shift_m':'own' with lines lt 1 title 'its own weight'
