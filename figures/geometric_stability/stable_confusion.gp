# A random pile, coloured by the boxes found to be stable; and the boxes that each way finds and misses.
tall = 1120
@PAGE
stats stem.'.csv' every ::0::0 using 'found' name 'found' nooutput
stats stem.'.csv' every ::0::0 using 'moving' name 'moving' nooutput
set multiplot
unset key; unset border; unset tics; unset grid
set origin 0,1 - 410.0/tall
set size 1,400.0/tall
load stem.'_pile.gp'
unset object
set size noratio; set size 1,1; set origin 0,0

# The colours of the picture.
set lmargin at screen 0.03; set rmargin at screen 0.97
set tmargin at screen 1 - 420.0/tall; set bmargin at screen 1 - 510.0/tall
set xrange [0:1]; set yrange [0:3]
swatch(k,x,y,c) = sprintf("set object %d rectangle from %g,%g to %g,%g fc rgb '%s' fs solid border lc rgb '#202020'; set label %d at %g,%g left", k, x, y + 0.2, x + 0.04, y + 0.8, c, k, x + 0.055, y + 0.5)
eval swatch(1, 0.00, 2, '#0072B2'); set label 1 'stable by corners and hull'
eval swatch(2, 0.53, 2, '#8ecdf2'); set label 2 'in balance: towers, islands'
eval swatch(3, 0.00, 1, '#f0e442'); set label 3 'rests, found by neither'
eval swatch(4, 0.53, 1, '#d55e00'); set label 4 'begins to move'
eval swatch(5, 0.00, 0, '#9a9a9a'); set label 5 'immovable'
plot NaN
unset object; unset label

# What each way finds.
set tmargin at screen 1 - 540.0/tall; set bmargin at screen 75.0/tall
set lmargin at screen 0.04; set rmargin at screen 0.945
set border 1 lc rgb '#808080'
set xtics 0,25 format '%g %%' nomirror textcolor rgb '#303030'
set xlabel 'movable boxes of all piles' offset 0,0.2
set xrange [0:100]; set yrange [6.05:-0.4]
set style fill solid 1.0 noborder
names = '"the thesis: four corners, all supports stable" "its footnote: hull of the supports" "hull, and towers upon what is stable" "every load on every top can be balanced" "balance of whole islands" "hull, towers, then balance of what is left"'
do for [k=0:5] { set label 10+k word(names, k+1) at 0.3,k+0.2 left textcolor rgb '#202020' }
set label 20 'called stable, rests' at 0.3,-0.22 left textcolor rgb '#0072B2'
set label 21 'missed' at 50*(found_max + 1 - moving_max),-0.22 center textcolor rgb '#6b6400'
set label 22 'moves' at 100 - 50*moving_max,-0.22 center textcolor rgb '#B35C00'
percent(x) = x >= 0.04 ? sprintf('%.0f %%', 100*x) : ''
bar(from,to) = sprintf("(50*(%s+(%s))):(column('level')+0.65):(100*(%s)):(100*(%s)):(column('level')+0.4):(column('level')+0.9)", from, to, from, to)
f = "column('found')"; e = "column('found')+column('false')"; m = "column('found')+column('false')+column('missed')"
set macros
FOUND = bar('0', f)
FALSE = bar(f, e)
MISSED = bar(e, m)
REST = bar(m, '1')
table = stem.'.csv'
plot table using @FOUND with boxxyerror lc rgb '#0072B2', \
  '' using @FALSE with boxxyerror lc rgb '#202020', \
  '' using @MISSED with boxxyerror lc rgb '#f0e442', \
  '' using @REST with boxxyerror lc rgb '#f3c3a2', \
  '' using (50*column('found')):(column('level')+0.65):(percent(column('found'))) with labels textcolor rgb '#ffffff', \
  '' using (100*(column('found')+0.5*column('missed'))):(column('level')+0.65):(percent(column('missed'))) with labels textcolor rgb '#202020', \
  '' using (100*(1-0.5*column('moving'))):(column('level')+0.65):(percent(column('moving'))) with labels textcolor rgb '#202020'
