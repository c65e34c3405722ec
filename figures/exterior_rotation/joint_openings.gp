# A column without glue comes apart as it falls: six moments, where each face is pressed, and hinges.
tall = 1200
@PAGE
set multiplot
height(points) = 1 - points*1.0/tall
frames = stem.'_frames.csv'
events = stem.'_events.csv'
wide_part = 1.0/3
frame_tall = 198*5.2/6.3
foot(row) = 6 + frame_tall + row*(frame_tall + 34)
do for [k=1:6] {
  column = (k - 1) % 3
  row = (k - 1) / 3
  set lmargin at screen wide_part*column + 0.004; set rmargin at screen wide_part*(column + 1) - 0.004
  set tmargin at screen height(foot(row) - frame_tall); set bmargin at screen height(foot(row))
  load stem.'_frame'.k.'.gp'
}
low = foot(1) + 28

# When that is, and what the marks mean.
set autoscale
do for [k=1:6] {
  stats frames using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label k sprintf('%.3f s', shown_max) at screen wide_part*((k - 1) % 3 + 0.5),height(foot((k - 1)/3) + 14) center front textcolor rgb '#202020'
}
set lmargin at screen 0.02; set rmargin at screen 0.98
set tmargin at screen height(low); set bmargin at screen height(low + 58)
set xrange [0:1]; set yrange [0:1]
set key inside center center vertical maxrows 2 samplen 2 width 1
plot NaN with lines dt 1 lw 5 lc rgb '#303030' title 'a face that holds', \
  NaN with points pt 7 ps (form eq 'svg' ? 0.9 : 1.2) lc rgb '#D55E00' title 'an edge that a box turns about'
unset key; unset label

@AXES
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0.9:1.9]; set xtics nomirror 0,0.2; set ytics nomirror
set format x ''
set style arrow 1 nohead lc rgb '#b8b8b8' lw 1 dt (3,3)

low = low + 104
set tmargin at screen height(low); set bmargin at screen height(low + 200)
side = 'pressed at [m]'; @SIDE
set yrange [0:1.15]; set ytics 0,0.25
set arrow 1 from graph 0,first 1 to graph 1,first 1 nohead lc rgb '#404040' lw 1
set label 1 'far edge of the face' at 0.92,1.06 left textcolor rgb soft
set key at screen 0.56,height(low - 36) center top horizontal maxcols 3 samplen 2.5 width 0
plot events using 'time_s':(0):(0):(1) with vectors arrowstyle 1 notitle, \
  for [k=1:3] stem.'.csv' using 'time_s':'glued'.k.'_m' with lines lt 8 dt (6,4) notitle, \
  for [k=1:3] '' using 'time_s':'pressed'.k.'_m' with lines lt 4 - k title (k == 1 ? 'lowest' : k == 2 ? 'middle' : 'top')
unset key; unset arrow; unset label

low = low + 226
set tmargin at screen height(low); set bmargin at screen height(low + 150)
side = 'its error [m]'; @SIDE
set logscale y; set mytics 1; set yrange [1e-16:1e-7]; set ytics 1e-16,1e4; set format y powers
# What is asked of the centre of pressure.
set arrow 1 from graph 0,first 1e-9 to graph 1,first 1e-9 nohead lc rgb '#404040' lw 1
set label 1 'tolerance' at 1.88,1e-8 right textcolor rgb soft
plot for [k=1:3] stem.'.csv' using 'time_s':(column('error'.k.'_m') + 1e-16) with lines lt 4 - k
unset logscale y; set mytics 1; unset arrow; unset label
set format y '%g'

low = low + 176
set tmargin at screen height(low); set bmargin at screen height(low + 210)
set format x '%g'
set xlabel 'time [s]' offset 0,0.3
side = 'angle between [°]'; @SIDE
set autoscale
stats stem.'.csv' using (column('hinge1_deg') > column('hinge2_deg') ? column('hinge1_deg') : column('hinge2_deg')) name 'hinge' nooutput
set xrange [0.9:1.9]; set yrange [0:1.05*hinge_max]; set ytics 0,5
plot events using 'time_s':(0):(0):(1.05*hinge_max) with vectors arrowstyle 1, \
  for [k=1:3] stem.'.csv' using 'time_s':'hinge'.k.'_deg' with lines lt 4 - k
