# Four bodies from above on which the two rules differ, and which of the rules is right.
tall = 1330
@PAGE
set multiplot
unset key; unset border; unset tics; unset grid
titles = '"a fifth support can lift it" "supports touch side by side" "a prism has no four corners" "a corner off the edge, enlarged"'
verdicts = '"it moves: the hull is right" "it rests: the corners are right" "it rests: the hull is right" "it moves: the corners are right"'
do for [k=1:4] {
  column = (k - 1) % 2
  row = (k - 1)/2
  set lmargin at screen 0.5*column + 0.05; set rmargin at screen 0.5*column + 0.45
  set tmargin at screen 1 - (62.0 + 320*row)/tall; set bmargin at screen 1 - (62.0 + 240 + 320*row)/tall
  set label 1 word(titles, k) at graph 0.5,1.17 center textcolor rgb '#202020'
  set label 2 word(verdicts, k) at graph 0.5,1.07 center textcolor rgb soft
  load stem.'_plan'.k.'.gp'
  plot NaN
}
unset label; unset object; unset arrow
# What the colours mean.
set tmargin at screen 1 - 648.0/tall; set bmargin at screen 1 - 750.0/tall
set lmargin at screen 0.03; set rmargin at screen 0.97
set xrange [0:1]; set yrange [0:3]
swatch(k,x,y,c,b) = sprintf("set object %d rectangle from %g,%g to %g,%g fc rgb '%s' fs solid border lc rgb '%s' lw 1.5; set label %d at %g,%g left", k, x, y + 0.2, x + 0.04, y + 0.8, c, b, k, x + 0.055, y + 0.5)
eval swatch(1, 0.00, 2, '#cfe3f1', '#0072B2'); set label 1 'stable support'
eval swatch(2, 0.50, 2, '#f9d9bf', '#D55E00'); set label 2 'one that is not'
set arrow 1 from 0.00,1.5 to 0.04,1.5 nohead lc rgb '#202020' lw 2; set label 3 'the body' at 0.055,1.5 left
set arrow 2 from 0.50,1.5 to 0.54,1.5 nohead lc rgb '#009E73' lw 4; set label 4 'hull of what holds it' at 0.555,1.5 left
set arrow 3 from 0.00,0.5 to 0.04,0.5 nohead lc rgb '#808080' lw 1.5 dt (6,4); set label 5 'what that one touches, or a tolerance' at 0.055,0.5 left
plot NaN
unset label; unset object; unset arrow

# Which rule is right.
set tmargin at screen 1 - 815.0/tall; set bmargin at screen 75.0/tall
set lmargin at screen 0.04; set rmargin at screen 0.945
set border 1 lc rgb '#808080'
set xtics 0,25 format '%g %%' nomirror textcolor rgb '#303030'
set xlabel 'bodies on which the rules differ' offset 0,0.2
set xrange [0:100]; set yrange [7.05:-0.1]
set style fill solid 1.0 noborder
names = '"piles: a support hangs over" "piles: a support is touched from the side" "piles: a support rests on such a one" "triangular prisms" "hexagonal prisms" "a corner cut off, tolerances of damped" "a tower that leans, tolerances of damped"'
set label 20 'hull right' at 0,-0.35 left textcolor rgb '#0072B2'
set label 21 'corners right' at 100,-0.35 right textcolor rgb '#B35C00'
table = stem.'.csv'
right(n) = 100.0*column('hull_right')/column('differ')
plot table using (0.5*right(0)):(column('kind')+0.65):(0):(right(0)):(column('kind')+0.4):(column('kind')+0.9) with boxxyerror lc rgb '#0072B2', \
  '' using (50+0.5*right(0)):(column('kind')+0.65):(right(0)):(100):(column('kind')+0.4):(column('kind')+0.9) with boxxyerror lc rgb '#E69F00', \
  '' using (0.3):(column('kind')+0.2):(sprintf('%s (%d)', word(names, int(column('kind')) + 1), int(column('differ')))) with labels left textcolor rgb '#202020'
