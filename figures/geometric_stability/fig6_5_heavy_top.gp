# A heavy top on two overhanging blocks: forces that balance, a top that is too light, and which tops stand.
tall = 1200
@PAGE
set multiplot
boxes = stem.'_boxes.csv'
unset border; unset tics; unset grid; unset key
set style fill solid 1.0 border lc rgb '#808080'
set lmargin at screen 0.0; set rmargin at screen 1.0
set xrange [-3.35:3.35]
shown(v, r) = column('view') == v && column('role') == r ? column('x_m') : NaN
half(name) = 0.5*column(name)
tone(r) = r == 0 ? '#c2cad1' : r == 1 ? '#e3e8ec' : '#f9d9c3'
set arrow 1 from -3.35,0 to 3.35,0 nohead lw 1.5 lc rgb '#808080'

# Forces on the body above, in weights of a lower block.
set tmargin at screen 0.995; set bmargin at screen 0.75
set yrange [-0.08:3.2]
long = 0.68  # [m] of arrow for the weight of a lower block
# Numbers stand below heads, those of middle arrows on the left, so that two neighbours do not meet.
beside(share, left) = share > 0.005 && (share > 0.3 && share < 0.7) == left ? column('x_m') : NaN
foot(share, y) = y - (share < 0.7 ? 0.36 : long*0.7)
set label 1 "heavy enough:\nforces in weights\nof a lower block" at -3.25,2.9 left textcolor rgb '#202020'
plot for [r=0:1] boxes using (shown(0, r)):'y_m':(half('width_m')):(half('height_m')) with boxxy dt 1 lw 1 lc rgb tone(r), \
  stem.'_forces.csv' using (column('share') > 0.005 ? column('x_m') : NaN):(column('y_m') - long*column('share')):(0):(long*column('share')) with vectors head filled size 0.1,22 fixed lt 1 lw 3, \
  '' using (beside(column('share'), 0)):(foot(column('share'), column('y_m'))):(sprintf('%.2f', column('share'))) with labels left offset 0.7,0 textcolor rgb '#0072B2', \
  '' using (beside(column('share'), 1)):(foot(column('share'), column('y_m'))):(sprintf('%.2f', column('share'))) with labels right offset -0.7,0 textcolor rgb '#0072B2'

set tmargin at screen 0.735; set bmargin at screen 0.49
set label 1 "too light:\nhow it starts"
plot for [r=0:2] boxes using (shown(1, r)):'y_m':(half('width_m')):(half('height_m')) with boxxy dt 1 lw 1 lc rgb tone(r), \
  stem.'_outlines.csv' using 'x_m':'y_m':'dx_m':'dy_m' with vectors nohead lw 1.5 dt (5,4) lc rgb '#D55E00', \
  stem.'_arrows.csv' using 'x_m':'y_m':'dx_m':'dy_m' with vectors head filled size 0.09,25 fixed lw 3 dt 1 lc rgb '#D55E00'
unset arrow; unset label
@AXES
set xtics nomirror; set ytics nomirror

# Which tops stand.
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.465; set bmargin at screen 0.185
set xrange [-0.26:0.26]; set yrange [0.3:0.95]
set xtics 0.1
set xlabel 'offset of the top block [m]' offset 0,0.5
side = 'mass of top over lower'; @SIDE
set key at screen 0.5,0.122 center top vertical maxcols 1 samplen 2
set label 1 'stands' at 0,0.9 center front textcolor rgb soft
set label 2 'friction can hold it' at 0,0.545 center textcolor rgb soft
set label 3 'falls' at 0,0.335 center textcolor rgb soft
set label 4 '2/3' at 0,14.0/21 center offset 0,-1.3 textcolor rgb '#202020'
set label 5 '70/93' at 0.2,14.0/18.6 center offset 0,-1.4 textcolor rgb '#202020'
m = form eq 'svg' ? 0.6 : 0.85  # of marks: terminals differ
runs = stem.'_runs.csv'
ran(kind, stands) = column('kind') == kind && column('stands') == stands ? column('offset_m') : NaN
set style fill solid 1.0 noborder
plot stem.'.csv' using 'offset_m':'by_hand':(0.95) with filledcurves lc rgb '#d9efe6' notitle, \
  '' using 'offset_m':'by_hand' with lines lt 8 lw 2 title 'by hand', \
  '' using 'offset_m':'rough_by_hand' with lines lt 8 lw 2 dt (8,5) title 'by hand, friction 0.5', \
  '' using 'offset_m':(column('offset_m') == 0 || abs(column('offset_m') - 0.2) < 1e-9 ? column('by_hand') : NaN) with points lt 8 pt 6 ps 2.2*m notitle, \
  '' using 'offset_m':'by_balance' with points lt 8 pt 1 ps 0.7 notitle, \
  '' using 'offset_m':'rough_by_balance' with points lt 8 pt 1 ps 0.7 notitle, \
  runs using (ran(0, 1)):'mass_ratio' with points lt 1 pt 7 ps m title 'contact\_damped (open: falls)', \
  '' using (ran(0, 0)):'mass_ratio' with points lt 1 pt 6 ps m lw 1 notitle, \
  '' using (ran(1, 1)):'mass_ratio' with points lt 2 pt 5 ps m title 'analytic (open: falls)', \
  '' using (ran(1, 0)):'mass_ratio' with points lt 2 pt 4 ps m lw 1 notitle, \
  '' using (ran(2, 1)):'mass_ratio' with points lt 3 pt 9 ps m title 'contact\_damped, friction 0.5 (open: falls)', \
  '' using (ran(2, 0)):'mass_ratio' with points lt 3 pt 8 ps m lw 1 notitle
