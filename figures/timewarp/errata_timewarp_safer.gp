# Errata of SAFERSYNCTIMEWARP, one in each row: on the left as printed, on the right corrected. Lines are the
# ways of the cubes' centres, dots are collisions. The number above a panel is the erratum's.
rows = 9
pitch = 270
tall = 40 + pitch*rows
@PAGE
array what[9] = [ \
  'F1  the collided states are thrown away', \
  'F2  valid times are never advanced', \
  'F3  neighbours are not put back', \
  'F4  neighbours are put where they were', \
  'F5  a collision that waits is lost', \
  'F6  the pair hinders itself', \
  'F7  neighbours are sought in the wrong place', \
  'F8  safer is not exact', \
  'F9  the cube that D meets in figure 5.1' ]
array says[9] = [ 'first cube at %.2g m', 'third cube at %.2g m', 'first cube at %.3g m', \
  'first cube at %.3g m', 'first cube at %.2g m', 'passes: %.0f', 'first cube at %.2g m', \
  'B collides %.0f times', 'foreseen: %.0f' ]
array low[9] = [-0.6, -0.6, -2.6, -2.6, -5, -0.4, -0.6, -0.05, -0.2]
array high[9] = [3.4, 5.6, 3.4, 3.4, 5, 3.4, 5.6, 0.85, 0.2]
ways = stem.'_ways.csv'
set multiplot
below = form eq 'svg' ? 0.8 : 0.4  # terminals put labels at different distances
unset key
top(row) = 1 - (100.0 + pitch*row)/tall
set label 90 'as printed' at screen 0.34,1-14.0/tall center textcolor rgb '#B34A00'
set label 91 'corrected' at screen 0.77,1-14.0/tall center textcolor rgb '#0060A0'
number(x) = abs(x) < 1e-5 ? 0 : x  # [m] ten times the resolution at these speeds
do for [k=1:8] {
  row = k - 1
  set tmargin at screen top(row); set bmargin at screen top(row)-130.0/tall
  set label 92 what[k] at screen 0.02,top(row)+48.0/tall textcolor rgb '#202020'
  side = 'position [m]'
  tic = k == 8 ? 0.2 : k == 5 ? 4 : 2
  set ytics tic
  if (k == 8) { set xlabel 'time in the frame [ms]' offset 0,below; set xtics 5 } \
  else { set xlabel 'time in the frame [s]' offset 0,below; set xtics 0.5 }
  do for [m=0:1] {
    set xrange [*:*]; set yrange [*:*]
    stats stem.'.csv' using (column('row') == k ? (m ? column('mended') : column('failure')) : NaN) name 'N' nooutput
    set xrange [0:k == 8 ? 16.67 : 1.03]; set yrange [low[k]:high[k]]
    set label 93 sprintf(says[k], number(N_max)) at graph 0,screen top(row)+18.0/tall left textcolor rgb (m ? '#0060A0' : '#B34A00')
    if (m) {
      set lmargin at screen 0.58; set rmargin at screen 0.96
      set format y ''; unset label 99; unset label 92
    } else {
      set lmargin at screen 0.15; set rmargin at screen 0.53
      set format y '%g'
      set label 99 side at screen 0.027,top(row)-65.0/tall center rotate textcolor rgb '#202020'
    }
    unit = k == 8 ? 1e3 : 1
    plot for [b=0:4] ways using (column('row') == k && column('mended') == m && column('body') == b ? unit*column('time_s') : NaN):'place_m' with lines lt b+1 lw 2, \
      for [b=0:4] '' using (column('row') == k && column('mended') == m && column('body') == b && column('hit') == 1 ? unit*column('time_s') : NaN):'place_m' with points lt b+1 ps 0.9
    unset label 90; unset label 91
  }
}
# F9: the cubes at the start, and the one that D meets as printed and as mended.
k = 9
row = k - 1
start = stem.'_start.csv'
set xrange [*:*]; set yrange [*:*]
stats start using (column(0) == 2 ? column('place_m') : NaN) name 'C' nooutput
stats start using (column(0) == 3 ? column('place_m') : NaN) name 'D' nooutput
stats start using (column(0) == 4 ? column('place_m') : NaN) name 'E' nooutput
set label 92 what[k] at screen 0.02,top(row)+48.0/tall textcolor rgb '#202020'
unset label 99; unset ytics; set border 1; unset grid
set xlabel 'position [m]' offset 0,below; set xtics 0.2
do for [m=0:1] {
  set xrange [*:*]; set yrange [*:*]
  stats stem.'.csv' using (column('row') == k ? (m ? column('mended') : column('failure')) : NaN) name 'N' nooutput
  set xrange [-0.1:0.75]; set yrange [low[k]:high[k]]
  set label 93 sprintf(says[k], N_max) at graph 0,screen top(row)+18.0/tall left textcolor rgb (m ? '#0060A0' : '#B34A00')
  set lmargin at screen (m ? 0.55 : 0.12); set rmargin at screen (m ? 0.96 : 0.53)
  set tmargin at screen top(row); set bmargin at screen top(row)-130.0/tall
  to = m ? E_max : C_max
  set arrow 1 from D_max,0.08 to to,0.08 head filled lw 2 lc rgb (m ? '#0072B2' : '#D55E00')
  plot start using 'place_m':(0):'half_m':'half_m' with boxxyerror fillstyle solid border rgb '#202020' lc rgb '#d4d4d4', \
    '' using 'place_m':(0):(sprintf('%c', 65+column(0))) with labels textcolor rgb '#202020'
  unset label 92
}
