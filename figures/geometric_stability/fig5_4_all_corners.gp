# A cube whole on a larger box: in space and from above.
tall = 425
@PAGE
set multiplot
outlines = stem.'_outlines.csv'
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
  stem.'_points.csv' using 'x_m':'z_m' with points pt 2 ps 0.5*mark lw 2 lc rgb '#202020'
set size noratio

verdict(stable) = stable ? 'stable' : 'not stable'
both = corners_stable == hull_stable ? verdict(hull_stable) : 'stable by one rule only'
set label 1 'top box: '.both at screen 0.75,height(14) center textcolor rgb '#202020'
set label 2 'if nothing were under the bottom box: '.verdict(without_stable) at screen 0.5,height(400) center textcolor rgb '#202020'

# What the marks mean.
set xrange [0:1]; set yrange [0:1] noreverse
set lmargin at screen 0.05; set rmargin at screen 0.98
set tmargin at screen height(284); set bmargin at screen height(374)
set key inside center center vertical maxrows 3 maxcols 2 samplen 1.5 width -2
plot NaN with lines lt 5 dt 1 lw 2.5 title 'top box', \
  NaN with lines lt 1 lw 2.5 title 'bottom box', \
  NaN with filledcurves lc rgb '#F0E442' title 'hull of contact points', \
  NaN with points pt 2 ps 0.5*mark lw 2 lc rgb '#202020' title 'contact point', \
  NaN with points pt 7 ps mark lc rgb '#56B4E9' title 'corner carried'
