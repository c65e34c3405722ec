# Five cubes on a line: the scene, then position and time of each under four techniques.
tall = 1100
@PAGE
set multiplot
scene = stem.'_scene.csv'
events = stem.'.csv'
stats scene using 'end_edges' name 'end' nooutput
stats scene using 'frame_ms' name 'frame' nooutput
stats scene using 'place_edges' name 'start' nooutput
stats stem.'_bands.csv' using 'place_edges' name 'seen' nooutput
frame = frame_max
height(points) = 1 - points*1.0/tall
letter(body) = substr('ABCDEFGHIJ', body + 1, body + 1)

# Lighter than the lines of other figures: the letters stand on them.
array light[5] = [0x8CC5EA, 0xF2C14E, 0x6CC7A8, 0xE3A6C6, 0xC4C4C4]
array dark[5] = [0x0072B2, 0x9A6A00, 0x00704F, 0x9C3F72, 0x4D4D4D]
tone(body) = light[int(body) + 1]
deep(body) = dark[int(body) + 1]
low = seen_min - 0.15
high = seen_max + 0.15
set xrange [low:high]

# The scene, to scale in both directions.
unset border; unset tics; unset grid; unset key
set lmargin at screen 0.03; set rmargin at screen 0.985
set tmargin at screen height(6); set bmargin at screen height(166)
tallness = (high - low)*160/(0.955*wide)  # edges that go into the height
set yrange [-0.62:tallness - 0.62]
way(body, from, to) = abs(to - from) > 0 ? to - from : NaN
level = 0.75
set label 1 sprintf('start; arrows: distance in a frame of %.1f ms', frame) at screen 0.03,height(15) left textcolor rgb soft
plot scene using 'place_edges':(0):(0.5):(0.5):(tone(column('body'))) with boxxy fs solid 1.0 border rgb '#606060' lw 1 dt 1 lc rgb variable, \
  '' using (column('speed_m_s') != 0 ? column('end_edges') : NaN):(0):(0.5):(0.5):(deep(column('body'))) with boxxy fs empty border lw 1.6 dt (6,4) lc rgb variable, \
  '' using 'place_edges':(level):(way(column('body'), column('place_edges'), column('end_edges'))):(0):(deep(column('body'))) with vectors head filled size 0.13,22 fixed lw 2.5 dt 1 lc rgb variable, \
  '' using 'place_edges':(0):(letter(column('body'))) with labels center font ',20' textcolor rgb '#202020', \
  '' using (column('speed_m_s') != 0 ? column('place_edges') + 0.02 : NaN):(level + 0.27):(sprintf('%.3g m/s', column('speed_m_s'))) with labels left textcolor rgb '#202020'
unset label

# Position across, time upwards: one panel for each technique.
@AXES
set grid x y
set xtics nomirror 0,2 offset 0,0.3; set ytics nomirror 0,5
set yrange [0:frame*1.03]
early = 0.05*frame  # where the letters stand
titles = '"simple: A passes B" "safer: the same order" "swept: as the reference" "reference"'
marked(panel, wrong) = column('panel') == panel && column('wrong') == wrong ? column('place_edges') : NaN
of(panel, body) = column('panel') == panel && column('body') == body ? column('place_edges') : NaN
mark = form eq 'svg' ? 1.55 : 2.9
digits = form eq 'svg' ? ',16' : ',14'
do for [panel=0:3] {
  left = panel % 2 == 0 ? 0.125 : 0.595
  top = panel < 2 ? 215 : 660
  set lmargin at screen left; set rmargin at screen left + 0.39
  set tmargin at screen height(top); set bmargin at screen height(top + 375)
  if (panel % 2 == 0) { set label 99 'time in the frame [ms]' at screen 0.02,height(top + 187) center rotate textcolor rgb '#202020' } else { unset label 99 }
  if (panel > 1) { set label 98 'position [edges]' at graph 0.5,screen height(1089) center textcolor rgb '#202020' }
  set label 1 word(titles, panel + 1) at graph 0.0,screen height(top - 14) left textcolor rgb '#202020'
  plot for [body=0:4] stem.'_bands.csv' using (of(panel, body)):'time_ms' with filledcurves closed lc rgb tone(body) fs solid 1.0 noborder, \
    stem.'_overlaps.csv' using (column('panel') == panel ? column('place_edges') : NaN):'time_ms' with filledcurves closed lc rgb '#202020' fs transparent pattern 4 noborder, \
    for [body=0:4] stem.'_bands.csv' using (of(panel, body)):'time_ms' with lines dt 1 lw 1 lc rgb deep(body), \
    scene using (column('place_edges') + (column('end_edges') - column('place_edges'))*early/frame):(early):(letter(column('body'))) with labels center textcolor rgb '#202020', \
    events using (marked(panel, 0)):'time_ms' with points pt 7 ps mark lc rgb '#202020', \
    events using (marked(panel, 1)):'time_ms' with points pt 5 ps mark lc rgb '#C00000', \
    events using (column('panel') == panel ? column('place_edges') : NaN):'time_ms':(sprintf('%d', column('number'))) with labels center font digits textcolor rgb 'white'
}
unset multiplot
