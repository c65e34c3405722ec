# Errata of damping and of the ending of overlap, one in each panel: dashed as printed, solid corrected.
rows = 4
each = 320.0
tall = 10 + each*rows
@PAGE
stack = stem.'_stack.csv'
stats stack using (column('printed_J')) name 'added' nooutput
set multiplot
unset key
left(k) = k % 2 == 0 ? 0.12 : 0.615
top(k) = 1 - (94.0 + each*(k/2))/tall
# The name of the erratum and what its axis shows stand above each panel.
PANEL = "set lmargin at screen left(k); set rmargin at screen left(k)+0.36; set tmargin at screen top(k); set bmargin at screen top(k)-135.0/tall; \
set label 91 name at screen left(k)-0.085,top(k)+73.0/tall left textcolor rgb '#202020'; \
set label 92 words at screen left(k)-0.085,top(k)+50.0/tall left textcolor rgb '#202020'; \
set label 99 side at screen left(k)-0.085,top(k)+19.0/tall left textcolor rgb soft"
NEXT = "unset label; unset arrow; k = k + 1"
ZERO = "set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 lw 1 dt (3,3)"
orange = "textcolor rgb '#B34A00'"
blue = "textcolor rgb '#0060A0'"

# DM7: two cubes that touch fall.
k = 0
name = 'DM7  falling cubes that'
words = 'touch are braked'
side = 'speed [m/s]'
@PANEL
set xlabel 'time [s]' offset 0,0.4
set xrange [0:1]; set xtics 0.5
set yrange [0:10.5]; set ytics 5
set label 1 'as printed' at first 0.97,3.1 right @orange
set label 2 'corrected' at first 0.55,7.6 right @blue
fall = stem.'_fall.csv'
plot fall using 'time_s':'mended_m_s' with lines lt 1, '' using 'time_s':'printed_m_s' with lines lt 2
@NEXT

# DM9: energy of a spin of which one component was ended.
name = 'DM9  ending one component'
words = 'of a spin adds energy'
side = 'energy after over before'
@PANEL
set xlabel 'tilt of the box [°]'
set xrange [0:90]; set xtics 45
set yrange [0:3]; set ytics 1
set label 1 '4×1×1' at first 45,2.15 center @orange
set label 2 '2×1×1' at first 45,1.5 center @orange
set label 3 'whole spin ended or kept' at first 45,0.65 center @blue
energy = stem.'_energy.csv'
plot energy using 'angle_deg':'beam_mended' with lines lt 1, '' using 'angle_deg':'beam_printed' with lines lt 2, '' using 'angle_deg':'brick_printed' with lines lt 2
@NEXT

# DM10: the way of a slide, seen from above.
name = 'DM10  the path of a slide'
words = 'bends towards an axis'
side = 'z [m], end of the path'
@PANEL
set xlabel 'x [m]'
set xrange [0.1:0.17]; set xtics 0.02
set yrange [0.055:0.098]; set ytics 0.02
set label 1 'as printed' at first 0.169,0.078 right @orange
set label 2 'corrected' at first 0.138,0.09 right @blue
path = stem.'_path.csv'
plot path using 'x_m':(column('whole') == 1 ? column('z_m') : NaN) with linespoints lt 1, \
  '' using 'x_m':(column('whole') == 0 ? column('z_m') : NaN) with linespoints lt 2
@NEXT

# DM11: let go beside a wall.
name = 'DM11  a cube that touches'
words = 'a wall hangs there'
side = 'distance down [m]'
@PANEL
set xlabel 'time [s]'
set xrange [0:1]; set xtics 0.5
set yrange [5:-0.6]; set ytics 0,2.5
set label 1 'as printed' at first 0.97,0.65 right @orange
set label 2 'corrected' at first 0.62,3.4 right @blue
wall = stem.'_wall.csv'
plot wall using 'time_s':'mended_m' with lines lt 1, '' using 'time_s':'printed_m' with lines lt 2
@NEXT

# DM12: the top of a throw.
name = 'DM12  a thrown cube hangs'
words = 'at its apex'
side = 'height [mm]'
@PANEL
set xlabel 'time [ms]'
set xrange [80:250]; set xtics 50
set yrange [80:148]; set ytics 20
set label 1 'as printed' at first 165,141 center @orange
set label 2 'corrected' at first 165,108 center @blue
apex = stem.'_apex.csv'
plot apex using 'time_ms':'mended_mm' with linespoints lt 1, '' using 'time_ms':'printed_mm' with linespoints lt 2
@NEXT

# DM14: a cube on its edge is turned upright.
name = 'DM14  a cube turned upright'
words = 'loses its contact'
side = 'gap below it [mm]'
@PANEL
set xlabel 'steps'
set xrange [0:6]; set xtics 2
set yrange [-2:27]; set ytics 10
@ZERO
set label 1 'about its centre' at first 3.8,23 right @orange
set label 2 'about its edge' at first 3,3.5 center @blue
tilt = stem.'_tilt.csv'
plot tilt using 'step':'mended_mm' with linespoints lt 1, '' using 'step':'printed_mm' with linespoints lt 2
@NEXT

# X3: pushes of 1 mm.
name = 'X3  pushes of 1 mm end an'
words = 'overlap and leave a gap'
side = 'gap left [mm]'
@PANEL
set xlabel 'overlap before [mm]'
set xrange [0:3]; set xtics 1
set yrange [-1.3:1.5]; set ytics 1
@ZERO
set label 1 'as printed' at first 2.95,1.25 right @orange
set label 2 'corrected' at first 2.95,-0.62 right @blue
gap = stem.'_gap.csv'
plot gap using 'depth_mm':(column('mended_mm')) with points pt 7 ps 0.25 lc rgb '#0072B2', '' using 'depth_mm':(column('printed_mm')) with points pt 5 ps 0.25 lc rgb '#D55E00'
@NEXT

# X6: a stack of five at rest.
name = 'X6  pushes add energy to'
words = 'a stack of five at rest'
side = 'added [J]'
@PANEL
set xlabel 'time [s]'
set xrange [0:*]; set xtics autofreq
set yrange [-0.3*added_max:1.15*added_max]; set ytics 20
@ZERO
set label 1 'none marked' at graph 0.55,0.75 right @orange
set label 2 'all marked stable' at graph 0.98,0.32 right @orange
set label 3 'velocities stopped' at graph 0.98,0.09 right @blue
plot stack using 'time_s':'mended_J' with lines lt 1, '' using 'time_s':'printed_J' with lines lt 2, '' using 'time_s':'stable_J' with lines lt 2
@NEXT
