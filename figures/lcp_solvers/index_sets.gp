# Baraff's algorithm on two planks: the contacts, the index sets in each step, forces, accelerations.
tall = 1260
@PAGE
set multiplot
path = stem.'_path.csv'
stats stem.'.csv' using 'step' name 'steps' nooutput
stats stem.'.csv' using 'contact' name 'contacts' nooutput
n = int(contacts_max)
big = form eq 'svg' ? 1.3 : 2
small = form eq 'svg' ? ',14' : ',11'
colours = '#0072B2 #D55E00 #009E73 #CC79A7 #E69F00'

# The planks, from the side; posts are dark.
unset border; unset grid; unset tics; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set origin 0.03,0.865; set size 0.94,0.13
set size ratio -1
stats stem.'_bodies.csv' using (column('x_m') + 0.5*column('width_m')) name 'right' nooutput
stats stem.'_bodies.csv' using (column('x_m') - 0.5*column('width_m')) name 'left' nooutput
set xrange [left_min - 0.1:right_max + 0.1]
set yrange [-0.02:0.76]
set arrow 1 from left_min - 0.1,0 to right_max + 0.1,0 nohead lw 1.5 lc rgb '#808080'
fixed(mass) = mass == 0 ? 0x9a9a9a : 0xeef1f4
plot stem.'_bodies.csv' using 'x_m':'y_m':(0.5*column('width_m')):(0.5*column('height_m')):(fixed(column('mass_kg'))) \
    with boxxy lc rgb variable fs solid 1.0 border lc rgb '#808080', \
  '' using (column('mass_kg') > 0 ? column('x_m') : NaN):'y_m' with points pt 1 ps 1.5 lw 2 lc rgb '#303030', \
  for [i=1:n] stem.'_contacts.csv' using 'x_m':'y_m' every ::i-1::i-1 with points pt 7 ps 1.1 lc rgb word(colours, i), \
  stem.'_contacts.csv' using (column('x_m') - 0.12):(column('y_m') + (column('contact') == 3 ? 0.1 : -0.13)):(sprintf('%d', column('contact'))) \
    with labels textcolor rgb '#202020'
unset arrow 1

# The sets: a row for each contact, a column for each step.
set size noratio
set lmargin at screen 0.18; set rmargin at screen 0.95
set xrange [0:steps_max]
set yrange [n + 0.5:0.5]
set tmargin at screen 0.79; set bmargin at screen 0.595
set border 15 lc rgb '#dddddd'
set tics scale 0
set xtics 1 format ''; set grid x lc rgb '#dddddd' lw 1 dt 1
set ytics 1,1,n textcolor rgb '#303030' format '%g'
side = 'contact'; @SIDE
cell(state) = column('state') == state ? column('contact') : NaN
set key at screen 0.53,0.862 center top vertical maxrows 3 samplen 0.5 width -2
plot stem.'.csv' using (column('ends') > 0 ? column('step') - 0.5 : NaN):'contact':(0.5):(0.5) \
    with boxxy lc rgb '#F7EE9A' fs solid 1.0 noborder title 'ends the step', \
  '' using (column('step') - 0.5):(cell(1)) with points pt 9 ps big lc rgb '#D55E00' title 'driven', \
  '' using (column('step') - 0.5):(cell(0)) with points pt 7 ps 0.5 lc rgb '#9a9a9a' title 'not yet', \
  '' using (column('step') - 0.5):(cell(2)) with points pt 7 ps big lc rgb '#0072B2' title 'C: pushes', \
  '' using (column('step') - 0.5):(cell(3)) with points pt 6 ps big lw 2 lc rgb '#0072B2' title 'NC: parts'

# What ended each step, below its column.
unset key; unset label 99; unset border; unset tics; unset grid
set tmargin at screen 0.60; set bmargin at screen 0.56
set yrange [0:1]
what(contact, end) = sprintf("%d\n%s", contact, end == 1 ? 'rests' : end == 2 ? 'parts' : 'returns')
plot stem.'.csv' using (column('ends') > 0 ? column('step') - 0.5 : NaN):(0.5):(what(column('contact'), column('ends'))) \
  with labels font small textcolor rgb soft

# Forces and accelerations after each step; in between they are linear.
@AXES
set grid x lc rgb '#dddddd' lw 1 dt 1
set xrange [0:steps_max]
set xtics 1 scale 0
set yrange [*:*]
set ytics autofreq scale 1 nomirror
set format y '%g'
set tmargin at screen 0.51; set bmargin at screen 0.315
side = 'force [N]'; @SIDE
set key at screen 0.62,0.545 center top horizontal maxrows 1 maxcols 5 samplen 2 width 0
set label 1 'contact' at screen 0.18,0.5375 textcolor rgb '#202020'
plot for [i=1:n] path using 'step':(column(1 + i)) with lines lt i lw 2.5 title sprintf('%d', i)

unset key; unset label 1
set tmargin at screen 0.28; set bmargin at screen 0.075
set format x '%g'
set xlabel 'steps done'
side = 'separating [m/s²]'; @SIDE
plot 0 with lines lt 8 lw 1, \
  for [i=1:n] path using 'step':(column(1 + n + i)) with lines lt i lw 2.5
