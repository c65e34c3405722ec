# Errata of SIMPLESYNCTIMEWARP, one in each row: on the left as printed, on the right corrected. Lines are
# the ways of the cubes' centres, dots are collisions. The number above a panel is the erratum's.
rows = 10
pitch = 270
tall = 40 + pitch*rows
@PAGE
array what[10] = [ \
  'T1  the pair collides in each turn of the loop', \
  'T2  both loops count with one counter', \
  'T3  one is tested before the other has flown', \
  'T4  the search does not know valid times', \
  'T5  only the end of the frame is tested', \
  'T6  nothing ends a train of bounces', \
  'T7  the overlapping end of a bracket is kept', \
  'T8  two parts of a flight are not the flight', \
  'T9  collisions at one time, one after the other', \
  'T10  the ground gets a valid time, too' ]
array says[10] = [ 'second cube at %.2g m', 'second cube at %.2g m', 'valid up to %.3g s', \
  'second event at %.3g s', 'third ahead by %.2g m', 'passes: %.0f', 'passes: %.0f', \
  'lands after %.3g ms', 'leaves with %.2g m/s', 'ground: %.3g ms' ]
array times[10] = [1, 1, 1, 1, 1, 1, 1, 1e3, 1, 1e3]
array low[10] = [-0.6, -0.6, -0.6, -0.9, -0.6, 0, -0.4, 0, -15, -0.6]
array high[10] = [3.4, 3.4, 3.4, 4.9, 4.6, 21, 2.2, 1.1, 30, 1.6]
ways = stem.'_ways.csv'
set multiplot
below = form eq 'svg' ? 0.8 : 0.4  # terminals put labels at different distances
unset key
top(row) = 1 - (100.0 + pitch*row)/tall
set label 90 'as printed' at screen 0.34,1-14.0/tall center textcolor rgb '#B34A00'
set label 91 'corrected' at screen 0.77,1-14.0/tall center textcolor rgb '#0060A0'
number(x) = abs(x) < 1e-9 ? 0 : x
do for [k=1:rows] {
  row = k - 1
  set tmargin at screen top(row); set bmargin at screen top(row)-130.0/tall
  set label 92 what[k] at screen 0.02,top(row)+48.0/tall textcolor rgb '#202020'
  side = k == 6 ? 'bounces' : k == 8 ? 'height [mm]' : k == 9 ? 'position [mm]' : 'position [m]'
    tic = k == 6 || k == 9 ? 10 : k == 8 ? 0.5 : k == 4 || k == 5 ? 2 : 1
  set ytics tic
  if (k == 10) {
    set ytics ('ground' 0, 'cube' 1)
    set xlabel 'valid time [ms]' offset 0,below; set xtics 5
  } else { if (k == 6 || k == 8) {
    set xlabel 'time in the frame [ms]' offset 0,below; set xtics 5
  } else {
    set xlabel 'time in the frame [s]' offset 0,below; set xtics 0.5
  } }
  do for [m=0:1] {
    set xrange [*:*]; set yrange [*:*]
    stats stem.'.csv' using (column('row') == k ? (m ? column('mended') : column('failure')) : NaN) name 'N' nooutput
    set xrange [0:k == 6 || k == 8 || k == 10 ? 16.67 : 1.03]; set yrange [low[k]:high[k]]
    set label 93 sprintf(says[k], number(N_max*times[k])) at graph 0,screen top(row)+18.0/tall left textcolor rgb (m ? '#0060A0' : '#B34A00')
    if (m) {
      set lmargin at screen 0.58; set rmargin at screen 0.96
      set format y ''; unset label 99; unset label 92
      if (k == 10) { set ytics ('' 0, '' 1) }
    } else {
      set lmargin at screen 0.15; set rmargin at screen 0.53
      set format y '%g'
      if (k < 10) { set label 99 side at screen 0.027,top(row)-65.0/tall center rotate textcolor rgb '#202020' }
    }
    # T3: up to when the cubes are valid.
    if (k == 3) { set arrow 1 from N_max,graph 0 to N_max,graph 1 nohead lt 8 lw 1.5 dt (3,3) } else { unset arrow 1 }
    colour = m ? '#0072B2' : '#D55E00'
    if (k == 6) {
      plot stem.(m ? '_bounces_mended.csv' : '_bounces_printed.csv') using 'time_ms':'count' with linespoints pt 7 ps 0.6 lw 1.5 lc rgb colour
    } else { if (k == 8) {
      plot stem.'_fall.csv' using 'time_ms':'mended_mm' with lines lw 6 lc rgb '#d4d4d4', \
        '' using 'time_ms':(m ? column('mended_mm') : column('printed_mm')) with lines lw 2 dt 1 lc rgb colour
    } else { if (k == 9) {
      plot ways using (column('row') == k && column('mended') == m && column('body') == 1 ? column('time_s') : NaN):(1e3*column('place_m')) with lines lw 2 dt 1 lc rgb colour, \
        '' using (column('row') == k && column('mended') == m && column('body') == 1 && column('hit') == 1 ? column('time_s') : NaN):(1e3*column('place_m')) with points pt 7 ps 0.8 lc rgb colour
    } else { if (k == 10) {
      plot stem.'_stamps.csv' using (0):'body':(0):(m ? column('mended_ms') : column('printed_ms')):(column('body')-0.25):(column('body')+0.25) with boxxyerror fillstyle solid lc rgb colour
    } else {
      plot for [b=0:2] ways using (column('row') == k && column('mended') == m && column('body') == b ? column('time_s') : NaN):'place_m' with lines lt b+1 lw 2, \
        for [b=0:2] '' using (column('row') == k && column('mended') == m && column('body') == b && column('hit') == 1 ? column('time_s') : NaN):'place_m' with points lt b+1 ps 0.9
    } } } }
    unset label 90; unset label 91
  }
}
