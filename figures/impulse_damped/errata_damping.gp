# Errata of damping and of the ending of overlap, one in each row: on the left as printed, on the
# right mended.
rows = 8
tall = 45 + 265*rows
@PAGE
stack = stem.'_stack.csv'
stats stack using (column('printed_J')) name 'added' nooutput
set multiplot
unset key
top(row) = 1 - (70.0 + 265*row)/tall
set label 90 'as printed' at screen 0.34,1-14.0/tall center
set label 91 'corrected' at screen 0.77,1-14.0/tall center
LEFT = 'set lmargin at screen 0.15; set rmargin at screen 0.53'
RIGHT = "set lmargin at screen 0.58; set rmargin at screen 0.96; set format y ''; unset label 99"
ROW = "set tmargin at screen top(row); set bmargin at screen top(row)-130.0/tall; set label 92 title_of_row at screen 0.02,top(row)+22.0/tall textcolor rgb '#202020'; set label 99 side at screen 0.027,top(row)-65.0/tall center rotate textcolor rgb '#202020'"
NEXT = "unset label 90; unset label 91; unset label 92; set format y '%g'; unset arrow; row = row + 1"
ZERO = "set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 lw 1 dt (3,3)"

# DM7: two cubes that touch fall.
row = 0
title_of_row = 'DM7  falling cubes that touch are braked'
side = 'speed [m/s]'
@ROW
set xlabel 'time [s]' offset 0,0.4
set xrange [0:1]; set xtics 0.5
set yrange [0:10.5]; set ytics 5
fall = stem.'_fall.csv'
@LEFT
set label 1 'levels off' at first 0.97,3.2 right
plot fall using 'time_s':'mended_m_s' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_s':'printed_m_s' with lines lt 2 dt 1
unset label 1
@RIGHT
set label 1 'falls' at first 0.5,7.5 right
plot fall using 'time_s':'mended_m_s' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_s':'mended_m_s' with lines lt 1
unset label 1
@NEXT

# DM9: energy of a spin of which one component was ended.
title_of_row = 'DM9  ending one component adds energy'
side = 'energy ratio'
@ROW
set xlabel 'tilt of the box [°]'
set xrange [0:90]; set xtics 45
set yrange [0:3]; set ytics 1
set arrow 2 from graph 0,first 1 to graph 1,first 1 nohead lt 8 lw 1 dt (3,3)
energy = stem.'_energy.csv'
@LEFT
set label 1 '4×1×1' at first 45,2.1 center
set label 2 '2×1×1' at first 45,0.75 center
plot energy using 'angle_deg':'beam_printed' with lines lt 2 dt 1, '' using 'angle_deg':'brick_printed' with lines lt 5
unset label 1; unset label 2
@RIGHT
plot energy using 'angle_deg':'beam_mended' with lines lt 1
@NEXT

# DM10: the way of a slide, seen from above.
title_of_row = 'DM10  a slide bends towards an axis'
side = 'z [m]'
@ROW
set xlabel 'x [m]'
set xrange [0:0.23]; set xtics 0.1
set yrange [0:0.15]; set ytics 0.1
path = stem.'_path.csv'
@LEFT
plot path using 'x_m':(column('whole') == 1 ? column('z_m') : NaN) with lines lw 6 lc rgb '#d4d4d4', \
  '' using 'x_m':(column('whole') == 0 ? column('z_m') : NaN) with linespoints lt 2 dt 1
@RIGHT
plot path using 'x_m':(column('whole') == 1 ? column('z_m') : NaN) with lines lw 6 lc rgb '#d4d4d4', \
  '' using 'x_m':(column('whole') == 1 ? column('z_m') : NaN) with linespoints lt 1
@NEXT

# DM11: let go beside a wall.
title_of_row = 'DM11  a cube hangs on a wall'
side = 'fall [m]'
@ROW
set xlabel 'time [s]'
set xrange [0:1]; set xtics 0.5
set yrange [5:-0.6]; set ytics 0,2.5
wall = stem.'_wall.csv'
@LEFT
set label 1 'hangs' at first 0.97,0.7 right
plot wall using 'time_s':'mended_m' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_s':'printed_m' with lines lt 2 dt 1
unset label 1
@RIGHT
plot wall using 'time_s':'mended_m' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_s':'mended_m' with lines lt 1
@NEXT

# DM12: the top of a throw.
title_of_row = 'DM12  a thrown cube hangs at its apex'
side = 'height [mm]'
@ROW
set xlabel 'time [ms]'
set xrange [80:250]; set xtics 50
set yrange [80:142]; set ytics 20
apex = stem.'_apex.csv'
@LEFT
set label 1 'hangs' at first 165,135 center
plot apex using 'time_ms':'mended_mm' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_ms':'printed_mm' with linespoints lt 2 dt 1
unset label 1
@RIGHT
plot apex using 'time_ms':'mended_mm' with lines lw 6 lc rgb '#d4d4d4', '' using 'time_ms':'mended_mm' with linespoints lt 1
@NEXT

# DM14: a cube on its edge is turned upright.
title_of_row = 'DM14  a cube turned upright loses its contact'
side = 'gap below [mm]'
@ROW
set xlabel 'steps'
set xrange [0:6]; set xtics 2
set yrange [-2:27]; set ytics 10
tilt = stem.'_tilt.csv'
@ZERO
@LEFT
set label 1 'about its centre' at first 6,5 right
plot tilt using 'step':'printed_mm' with linespoints lt 2 dt 1
unset label 1
@RIGHT
set label 1 'about its edge' at first 3,6 center
plot tilt using 'step':'mended_mm' with linespoints lt 1
unset label 1
@NEXT

# X3: pushes of 1 mm.
title_of_row = 'X3  pushes of 1 mm leave a gap'
side = 'gap left [mm]'
@ROW
set xlabel 'overlap before [mm]'
set xrange [0:3]; set xtics 1
set yrange [-1.2:1.2]; set ytics 1
gap = stem.'_gap.csv'
@ZERO
@LEFT
set label 1 'gap' at first 2.9,0.85 right
plot gap using 'depth_mm':(column('printed_mm')) with points pt 7 ps 0.25 lc rgb '#D55E00'
unset label 1
@RIGHT
set label 1 'still in touch' at first 2.9,-0.6 right
plot gap using 'depth_mm':(column('mended_mm')) with points pt 7 ps 0.25 lc rgb '#0072B2'
unset label 1
@NEXT

# X6: a stack of five at rest.
title_of_row = 'X6  pushes add energy to a stack of five at rest'
side = 'added [J]'
@ROW
set xlabel 'time [s]'
set xrange [0:*]; set xtics autofreq
set yrange [-0.09*added_max:1.15*added_max]; set ytics 20
@ZERO
@LEFT
set label 1 'none marked' at graph 0.54,0.8 right
set label 2 'all marked' at graph 0.98,0.24 right
plot stack using 'time_s':'printed_J' with lines lt 2 dt 1, '' using 'time_s':'stable_J' with lines lt 5
unset label 1; unset label 2
@RIGHT
set label 1 'velocities stopped' at graph 0.5,0.3 center
plot stack using 'time_s':'mended_J' with lines lt 1
unset label 1
@NEXT
