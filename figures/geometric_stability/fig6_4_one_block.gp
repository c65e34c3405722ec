# A staircase of blocks: its levels, one block in its place, how it tips; and work for longer series.
tall = 800
@PAGE
set multiplot
boxes = stem.'_boxes.csv'
one = stem.'_one.csv'
stats one using (column('mass_kg')) name 'mass' nooutput
stats one using (column('force_N')) name 'force' nooutput
stats one using (column('x_m')) name 'one_x' nooutput
stats one using (column('y_m')) name 'one_y' nooutput
stats one using (column('support_x_m')) name 'support_x' nooutput
stats one using (column('support_y_m')) name 'support_y' nooutput
stats one using (column('overhang')) name 'overhang' nooutput
stats one using (column('beyond')) name 'beyond' nooutput
stats boxes using (column('view') == 0 ? column('y_m') + 0.5*column('height_m') : 1/0) name 'top' nooutput
unset border; unset tics; unset grid; unset key
set style fill solid 1.0 border lc rgb "#808080"
wide_m = 2.75*(top_max + 0.75)/3.75  # [m] of a view, so that metres are alike on both axes
left_m = -1.08*wide_m/2.75
set xrange [left_m:left_m + wide_m]; set yrange [-0.12:top_max + 0.63]
set tmargin at screen 0.985; set bmargin at screen 0.54
shown(v, r) = column('view') == v && column('role') == r ? column('x_m') : NaN
half(name) = 0.5*column(name)
tone(r) = r == 0 ? '#c2cad1' : r == 1 ? '#e3e8ec' : '#f9d9c3'
set arrow 1 from left_m,0 rto wide_m,0 nohead lw 1.5 lc rgb '#808080'
high = top_max + 0.42

# As it stands.
set lmargin at screen 0.005; set rmargin at screen 0.325
set label 1 sprintf('offset %.2f m: stands', overhang_max) at left_m + 0.5*wide_m,high center textcolor rgb '#202020'
plot for [r=0:1] boxes using (shown(0, r)):'y_m':(half('width_m')):(half('height_m')) with boxxy dt 1 lw 1 lc rgb tone(r), \
  stem.'_levels.csv' using 'left_m':'y_m':(column('right_m') - column('left_m')):(0) with vectors nohead lt 1 lw 5, \
  '' using 'centre_m':'y_m' with points lt 2 pt 7 ps 0.9

# One block in its place: the force of the base, and the weight.
set lmargin at screen 0.34; set rmargin at screen 0.66
set label 1 'as one block'
long = 0.9*support_y_max/force_max  # [m] of arrow for a newton
set label 2 sprintf('%.1f kg', mass_max) at one_x_max - 0.42,one_y_max + 0.55 center front textcolor rgb '#202020'
set arrow 2 from one_x_max,one_y_max rto 0,-1.5*long*force_max head filled size 0.14,22 fixed lc rgb '#D55E00' dt 1 lw 3 front
set arrow 3 from support_x_max,support_y_max - long*force_max to support_x_max,support_y_max - 0.02 head filled size 0.14,22 fixed lt 1 lw 3 front
plot for [r=0:1] boxes using (shown(1, r)):'y_m':(half('width_m')):(half('height_m')) with boxxy dt 1 lw 1 lc rgb tone(r), \
  one using 'x_m':'y_m' with points lt 2 pt 7 ps 0.9
unset arrow 2; unset arrow 3; unset label 2

# A step too far.
set lmargin at screen 0.675; set rmargin at screen 0.995
set label 1 sprintf('offset %.2f m: tips', beyond_max)
plot for [r=0:2] boxes using (shown(2, r)):'y_m':(half('width_m')):(half('height_m')) with boxxy dt 1 lw 1 lc rgb tone(r), \
  stem.'_outlines.csv' using 'x_m':'y_m':'dx_m':'dy_m' with vectors nohead lw 1.5 dt (5,4) lc rgb '#D55E00', \
  stem.'_arrows.csv' using 'x_m':'y_m':'dx_m':'dy_m' with vectors head filled size 0.09,25 fixed lw 3 dt 1 lc rgb '#D55E00'
unset arrow; unset label
@AXES
set xtics nomirror; set ytics nomirror

# Work.
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.50; set bmargin at screen 0.115
set xrange [0:*]; set yrange [30:1e8]
set logscale y; set format y powers
set xlabel 'blocks in the series' offset 0,0.3
side = 'multiplications'; @SIDE
set key at graph 0.02,0.985 left top vertical maxcols 1 samplen 3
plot stem.'.csv' using 'blocks':'equilibrium' with linespoints lt 1 title 'balance, block by block', \
  '' using 'blocks':'baraff' with linespoints lt 2 title 'all contact forces, Baraff', \
  '' using 'blocks':'one' with linespoints lt 3 title 'balance, the series as one block'
