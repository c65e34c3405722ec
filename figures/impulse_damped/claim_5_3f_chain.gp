# Two boxes on a sled: where they are at the end, and their speeds.
tall = 1120
@PAGE
set multiplot
boxes = stem.'_boxes.csv'
stats stem.'.csv' using 'time_s' name 'time' nooutput
unset border; unset tics; unset grid; unset key
set lmargin at screen 0.02; set rmargin at screen 0.98
set xrange [-1.75:2.45]
set style fill solid 1.0 noborder
OUTLINE = "boxes using 'start_x_m':'y_m':(0.5*column('width_m')):(0.5*column('height_m')) with boxxy fs empty lt 8 dt 1 lc rgb '#8c8c8c' lw 1.5"
shade(k) = k == 0 ? 0xdde3e8 : k == 1 ? 0xE69F00 : 0x56B4E9
set yrange [-0.05:1.0]
set arrow 1 from -1.75,0 to 2.45,0 nohead lw 1.5 lc rgb '#808080'
do for [k=1:2] {
  set tmargin at screen (k == 1 ? 0.99 : 0.855); set bmargin at screen (k == 1 ? 0.88 : 0.745)
  end = k == 1 ? 'coulomb_x_m' : 'damped_x_m'
  set label 1 sprintf("%s, after %g s (grey: the start)", k == 1 ? 'Coulomb' : 'damped', time_max) at -1.7,0.83 left textcolor rgb '#202020'
  plot boxes using end:'y_m':(0.5*column('width_m')):(0.5*column('height_m')):(shade($0)) with boxxy lc rgb variable, @OUTLINE
}
unset arrow; unset label
@AXES
set xtics nomirror; set ytics nomirror
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:time_max]; set yrange [-0.05:1.1]
do for [k=1:2] {
  set tmargin at screen (k == 1 ? 0.70 : 0.395); set bmargin at screen (k == 1 ? 0.425 : 0.12)
  way = k == 1 ? 'coulomb' : 'damped'
  if (k == 1) { set format x '' } else { set format x '%g'; set xlabel 'time [s]' }
  side = sprintf('%s: speed [m/s]', k == 1 ? 'Coulomb' : 'damped'); @SIDE
  set key at graph 0.99,0.985 right top vertical maxcols 1 samplen 3
  plot stem.'.csv' using 'time_s':way.'_sled_m_s' with lines lt 8 lw 2.5 title 'sled', \
    '' using 'time_s':way.'_load1_m_s' with lines lt 5 title 'lower box', \
    '' using 'time_s':way.'_load2_m_s' with lines lt 6 title 'upper box'
}
