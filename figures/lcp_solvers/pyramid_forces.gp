# Forces in a pyramid: arrows on feet, bars with the answers of solvers on full faces.
tall = 980
@PAGE
mark = form eq 'svg' ? 0.65 : 1.1  # size of marks
set multiplot
bricks = stem.'_bricks.csv'
stats bricks using (column('x_m') + 0.5*column('width_m')) name 'right' nooutput
stats bricks using (column('y_m') + 0.5*column('height_m')) name 'top' nooutput
stats bricks using 'height_m' name 'brick' nooutput
stats stem.'.csv' using 'feet' name 'feet' nooutput
stats stem.'.csv' using 'most' name 'most' nooutput
h = brick_max
unset border; unset grid; unset tics; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
half = 1.04*right_max
set xrange [-half:half]
set yrange [-0.12*h:top_max + 0.1*h]
set size ratio -1
set arrow 1 from -half,0 to half,0 nohead lw 1.5 lc rgb '#808080'
set style fill solid 1.0 border lc rgb '#808080'
drawn = "bricks using 'x_m':'y_m':(0.5*column('width_m')):(0.5*column('height_m')) with boxxy lc rgb '#eef1f4'"
shown(value) = sprintf('%.3g', value)

# On feet: an arrow that fills most of a brick is the largest force.
scale = 0.78*h/feet_max
set origin 0,0.515; set size 1,0.44
set label 1 'on feet: one answer' at graph 0.5,1.06 center textcolor rgb '#202020'
set arrow 2 from graph 0.95,0.76 rto 0,first scale heads size graph 0.008,90 lc rgb soft lw 1.5
set label 2 "weight of\na brick" at graph 0.935,0.835 right textcolor rgb soft
plot @drawn, \
  stem.'_feet.csv' using 'x_m':'y_m' with points pt 5 ps 0.7*mark lc rgb '#303030', \
  stem.'.csv' using 'feet_x_m':'y_m':(0):(scale*column('feet')) with vectors lw 3.5 dt 1 lc rgb '#0072B2' head size 0.07*h,22 fixed filled, \
  '' using (column('feet_x_m') + 0.05):(column('y_m') + 0.5*scale*column('feet')):(shown(column('feet'))) with labels left textcolor rgb '#202020'

# On full faces: a bar from the smallest to the largest force, the answers side by side in it.
scale = 0.92*h/most_max
set origin 0,0.01; set size 1,0.44
set label 1 'on full faces: a range, and four right answers'
set arrow 2 from graph 0.95,0.76 rto 0,first scale heads size graph 0.008,90 lc rgb soft lw 1.5
place(k) = column('x_m') + 0.055*(k - 2.5)
level(name) = column('y_m') + scale*column(name)
set key at graph 0.0,0.99 left top vertical maxcols 1 Left reverse samplen 1
plot @drawn notitle, \
  stem.'.csv' using 'x_m':'y_m':(0):(scale*column('least')) with vectors nohead lw 1.5 dt 1 lc rgb '#b59f00' notitle, \
  stem.'.csv' using 'x_m':(level('least')):(column('x_m') - 0.13):(column('x_m') + 0.13):(level('least')):(level('most')) with boxxy lc rgb '#F7EE9A' lw 1.2 dt 1 fs solid 1.0 border lc rgb '#b59f00' title 'possible', \
  '' using (place(1)):(level('baraff')) with points lt 1 ps mark title 'Baraff', \
  '' using (place(2)):(level('lemke')) with points lt 2 ps mark title 'Lemke', \
  '' using (place(3)):(level('gauss_seidel')) with points lt 3 ps 1.2*mark title 'Gauss–Seidel', \
  '' using (place(4)):(level('multipliers')) with points lt 4 ps 1.2*mark title 'multipliers'
