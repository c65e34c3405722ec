# One frame of a timewarp, collision by collision: ways that are valid and ways that are not, and the queue.
tall = 1190
@PAGE
set multiplot
load stem.'_words.gp'
ways = stem.'_ways.csv'
stats ways using 'place_m' name 'seen' nooutput
stats ways using 'time_s' name 'time' nooutput
stats ways using 'body' name 'body' nooutput
height(points) = 1 - points*1.0/tall
letter(body) = substr('ABCDEFGHIJ', body + 1, body + 1)
array light[5] = [0x8CC5EA, 0xF2C14E, 0x6CC7A8, 0xE3A6C6, 0xC4C4C4]
array dark[5] = [0x0072B2, 0x9A6A00, 0x00704F, 0x9C3F72, 0x4D4D4D]
tone(body) = light[int(body) % 5 + 1]
deep(body) = dark[int(body) % 5 + 1]

# What the marks mean.
unset border; unset tics; unset grid
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0.03; set rmargin at screen 0.98
set tmargin at screen height(4); set bmargin at screen height(104)
mark = form eq 'svg' ? 1.0 : 1.6
set key inside center center vertical maxrows 3 maxcols 2 samplen 1.6 width 1
plot NaN with filledcurves closed lc rgb tone(0) fs solid 1.0 border lc rgb deep(0) title 'valid', \
  NaN with lines dt (6,4) lw 1.6 lc rgb deep(0) title 'test', \
  NaN with points pt 7 ps 0.7*mark lc rgb '#202020' title 'valid time', \
  NaN with points pt 5 ps 1.2*mark lc rgb '#C00000' title 'resolved', \
  NaN with points pt 4 ps 1.2*mark lw 2.5 lc rgb '#C00000' title 'put back', \
  NaN with points pt 6 ps 1.2*mark lw 2 lc rgb '#202020' title 'waits'

# Place across, time upwards: a panel for each collision that is taken out of the queue.
@AXES
unset key
set grid x y
set xrange [seen_min - 0.15:seen_max + 2.3]; set yrange [0:1.04*time_max]
set xtics nomirror 0,2 offset 0,0.3; set ytics nomirror 0,0.5*time_max
of(panel, body, test) = column('panel') == panel && column('body') == body && column('test') == test ? column('place_m') : NaN
in(panel) = column('panel') == panel ? column('place_m') : NaN
kind(panel, taken) = column('panel') == panel && column('taken') == taken ? column('place_m') : NaN
do for [panel=1:|heading|] {
  left = panel % 2 == 1 ? 0.13 : 0.6
  top = 145 + 345*((panel - 1)/2)
  set lmargin at screen left; set rmargin at screen left + 0.385
  set tmargin at screen height(top); set bmargin at screen height(top + 265)
  if (panel % 2 == 1) { set label 99 'time [s]' at screen 0.02,height(top + 132) center rotate textcolor rgb '#202020' } else { unset label 99 }
  if (panel > |heading| - 2) { set label 98 'position [m]' at graph 0.5,screen height(top + 316) center textcolor rgb '#202020' }
  set label 1 sprintf('%d  %s', panel, heading[panel]) at screen left - 0.05,height(top - 15) left textcolor rgb '#202020'
  set label 2 queue[panel] at graph 0.61,0.40 left textcolor rgb '#0072B2'
  plot for [body=0:int(body_max)] ways using (of(panel, body, 0)):'time_s' with filledcurves closed lc rgb tone(body) fs solid 1.0 noborder, \
    for [body=0:int(body_max)] ways using (of(panel, body, 0)):'time_s' with lines dt 1 lw 1 lc rgb deep(body), \
    for [body=0:int(body_max)] ways using (of(panel, body, 1)):'time_s' with filledcurves closed lc rgb tone(body) fs transparent solid 0.16 noborder, \
    for [body=0:int(body_max)] ways using (of(panel, body, 1)):'time_s' with lines dt (6,4) lw 1.6 lc rgb deep(body), \
    stem.'_dots.csv' using (in(panel)):'time_s' with points pt 7 ps 0.7*mark lc rgb '#202020', \
    stem.'_dots.csv' using (column('panel') == panel ? column('early_m') : NaN):'early_s':(letter(column('body'))) with labels center textcolor rgb '#202020', \
    stem.'.csv' using (kind(panel, 0)):'time_s' with points pt 6 ps 1.2*mark lw 2 lc rgb '#202020', \
    stem.'.csv' using (kind(panel, 1)):'time_s' with points pt 5 ps 1.2*mark lc rgb '#C00000', \
    stem.'.csv' using (kind(panel, 2)):'time_s' with points pt 4 ps 1.2*mark lw 2.5 lc rgb '#C00000'
}
unset multiplot
