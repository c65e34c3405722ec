# Errata of the test of geometric stability, one in each row: on the left as printed, on the right
# mended. Dark boxes are called stable.
scenes = 'G2 G3 G4 G5 G6 G7 G8'
titles(k) = word('beside_each_other:_one_of_two an_unstable_support_listed_first a_fixed_wall_loses_its_flag marks_of_the_step_before four_corners,_and_one_unstable_support a_cube_that_goes_up a_millionth_from_level', k)
rows = words(scenes)
tall = 95 + 150*rows
@PAGE
set multiplot
unset key; unset border; unset tics; unset grid
set label 90 'as printed' at screen 0.28,1-14.0/tall center
set label 91 'corrected' at screen 0.76,1-14.0/tall center
top(row) = 1 - (62.0 + 150*row)/tall
grey = '#bdbdbd'
dark = '#0072B2'
light = '#ffffff'
PANEL = "set tmargin at screen top(row); set bmargin at screen top(row)-105.0/tall"
# Boxes stand on y = 0; a panel is 200 points wide and 105 high.
high(k) = k == 4 ? 3.2 : (k == 5 || k == 8) ? 2.15 : 1.6
do for [k=2:8] {
  row = k - 2
  side = ''
  name = titles(k-1)
  text = ''
  do for [i=1:strlen(name)] { text = text.(name[i:i] eq '_' ? ' ' : name[i:i]) }
  set label 92 'G'.k.'  '.text at screen 0.02,top(row)+20.0/tall textcolor rgb '#202020'
  half = high(k)*260.0/105.0/2
  middle = k == 4 ? 0.5 : (k == 5 ? 0.4 : 0)
  set xrange [middle-half:middle+half]
  set yrange [0:high(k)]
  set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 lw 1.5
  do for [panel=0:1] {
    @PANEL
    set lmargin at screen (panel ? 0.55 : 0.07)
    set rmargin at screen (panel ? 0.97 : 0.49)
    flag = panel ? 'mended' : 'printed'
    plot stem.'.csv' using (column('scene') == k ? column('x_m') : NaN):'y_m':(column('width_m')/2):(column('height_m')/2):(column('fixed') == 1 && column(flag) == 1 ? 0x8a8a8a : column(flag) == 1 ? 0x0072B2 : 0xFBE3C8) with boxxyerror fillstyle solid border rgb '#202020' lc rgb variable
    unset label 90; unset label 91
  }
}
# The key.
set tmargin at screen 40.0/tall; set bmargin at screen 5.0/tall
set lmargin at screen 0.02; set rmargin at screen 0.98
unset arrow; unset label 92
set xrange [0:1]; set yrange [0:1]
set object 1 rectangle from 0.02,0.2 to 0.06,0.75 fillcolor rgb '#0072B2' fillstyle solid border rgb '#202020'
set label 1 'stable' at 0.08,0.47
set object 2 rectangle from 0.25,0.2 to 0.29,0.75 fillcolor rgb '#FBE3C8' fillstyle solid border rgb '#202020'
set label 2 'not stable' at 0.31,0.47
set object 3 rectangle from 0.55,0.2 to 0.59,0.75 fillcolor rgb '#8a8a8a' fillstyle solid border rgb '#202020'
set label 3 'immovable' at 0.61,0.47
plot NaN
