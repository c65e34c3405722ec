# The pyramid of figure 5.6 with and without a gap between neighbours, and its unknown forces.
tall = 720
@PAGE
set multiplot
boxes = stem.'.csv'
unknowns = stem.'_unknowns.csv'
stats boxes using (column('x_m') + 0.5*column('width_m')) name 'right' nooutput
stats boxes using (column('y_m') + 0.5*column('height_m')) name 'top' nooutput
stats unknowns using 'gap' name 'gap' nooutput
stats unknowns using 'all' name 'all' nooutput
dark = 0x3D3D3D
light = 0xDCDCDC
blue = 0x56B4E9  # bears every load, but not by the rule

# Side views.
unset key; unset border; unset tics; unset grid
half = 1.04*right_max
set xrange [-half:half]
set yrange [-0.02*top_max:1.02*top_max]
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set arrow 1 from -half,0 to half,0 nohead lw 1.5 lc rgb '#808080'
colour(c) = c == 1 ? dark : (c == 2 ? blue : light)
apart = sprintf('%g of an edge apart', gap_max)
do for [panel=0:1] {
  set label 1 (panel ? 'neighbours touch' : apart) at screen (panel ? 0.75 : 0.25),0.972 center textcolor rgb '#202020'
  set origin (panel ? 0.51 : 0.01),0.54
  set size 0.48,0.41
  plot boxes using (column('panel') == panel ? column('x_m') : NaN):'y_m':(0.5*column('width_m')):(0.5*column('height_m')):(colour(column('colour'))) with boxxyerror fs solid 1.0 border rgb '#202020' lw 1 lc rgb variable
}
unset arrow 1; unset label 1

# What the colours mean.
set origin 0,0.455; set size noratio; set size 1,0.06
set xrange [0:1]; set yrange [0:1]
set object 1 rectangle from 0.03,0.2 to 0.065,0.85 fc rgb dark fs solid 1.0 border rgb '#202020'
set label 1 'stable' at 0.08,0.5 textcolor rgb '#202020'
set object 2 rectangle from 0.23,0.2 to 0.265,0.85 fc rgb light fs solid 1.0 border rgb '#202020'
set label 2 'not stable' at 0.28,0.5 textcolor rgb '#202020'
set object 3 rectangle from 0.50,0.2 to 0.535,0.85 fc rgb blue fs solid 1.0 border rgb '#202020'
set label 3 'not, but bears every load' at 0.55,0.5 textcolor rgb '#202020'
plot NaN
unset object; unset label

# Unknown forces: bars with their numbers, a group for each pyramid.
@AXES
set border 0
unset grid
set tics scale 0
set origin 0,0; set size 1,0.45
set lmargin at screen 0.43; set rmargin at screen 0.91
set tmargin at screen 0.44; set bmargin at screen 0.02
set xrange [0:1.04*all_max]
set yrange [-9.6:1.6]
unset xtics
names = 'all rule load_proof balance'
shade(k) = k == 0 ? light : k == 1 ? dark : blue
place(gap, k) = (gap > 0 ? 0 : -6) - k
set label 1 'unknown forces, '.apart.'; left out:' at screen 0.03,first 1 left textcolor rgb '#202020'
set label 2 'unknown forces, neighbours touch; left out:' at screen 0.03,first -5 left textcolor rgb '#202020'
set ytics ('no box' 0, 'stable boxes' -1, 'bear every load' -2, 'all in balance' -3, \
           'no box' -6, 'stable boxes' -7, 'bear every load' -8, 'all in balance' -9)
plot for [k=0:3] unknowns using (0.5*column(word(names, k+1))):(place(column('gap'), k)):(0.5*column(word(names, k+1))):(0.36) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb shade(k), \
  for [k=0:3] '' using (column(word(names, k+1)) + 0.012*all_max):(place(column('gap'), k)):(sprintf('%d', column(word(names, k+1)))) with labels left textcolor rgb '#202020'
