# A stable box slides off another one: four moments, its speed, and which steps count.
tall = 1270
@PAGE
set multiplot
height(points) = 1 - points*1.0/tall
do for [k=1:4] {
  left = (k - 1) % 2
  row = (k - 1) / 2
  set origin 0.5*left,height(195 + 225*row)
  set size 0.5,190.0/tall
  stats stem.'_frames.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.2f s', shown_max) at screen 0.5*left + 0.25,height(207 + 225*row) center textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
}
unset object
unset label 1

@AXES
set origin 0,0; set size noratio 1,1
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen height(555); set bmargin at screen height(795)
set xrange [0:0.5]; set xtics nomirror 0,0.1; set ytics nomirror
set yrange [0:*]
set xlabel 'time [s]' offset 0,0.5
side = 'speed [m/s]'; @SIDE
set key at screen 0.56,height(470) center top vertical maxrows 2 maxcols 2 samplen 2.5 width -1
table = stem.'.csv'
big = form eq 'svg' ? 1.1 : 1.5
plot table using 'time_s':'free_m_s' with lines lt 3 title 'analytic, no friction', \
  '' using 'time_s':'analytic_m_s' with lines lt 2 title 'analytic, damped', \
  '' using 'time_s':'damped_m_s' with lines lt 1 title 'damped integration', \
  '' using 'time_s':'free_stable_m_s' with points pt 7 ps big lc rgb '#3D3D3D' title 'all corners carried', \
  '' using 'time_s':'analytic_stable_m_s' with points pt 7 ps big lc rgb '#3D3D3D' notitle, \
  '' using 'time_s':'damped_stable_m_s' with points pt 7 ps big lc rgb '#3D3D3D' notitle

set tmargin at screen height(960); set bmargin at screen height(1175)
set key at screen 0.56,height(882) center top vertical maxrows 2 maxcols 1 samplen 1.5 width 0
set xrange [*:*] noextend; set xtics nomirror 1
set yrange [0:*]
set xlabel 'speed at the start [m/s]' offset 0,0.2
side = 'steps until it leaves'; @SIDE
set boxwidth 0.7
set style fill solid 1.0 border rgb '#202020'
bars = stem.'_speeds.csv'
plot bars using 'speed_m_s':'steps' with boxes fc rgb '#E69F00' lw 0.7 dt 1 title 'first step, not classified yet', \
  '' using 'speed_m_s':'counted' with boxes fc rgb '#5A5A5A' lw 0.7 dt 1 title 'stable, slides, damped'
