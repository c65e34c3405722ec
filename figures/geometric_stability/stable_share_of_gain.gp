# Unknown forces that the listing removes, as printed and mended: by right, by luck, wrongly; and each
# erratum by itself.
tall = 1135
@PAGE
set multiplot
set lmargin at screen 0.36; set rmargin at screen 0.965
by_right = '#0072B2'
by_luck = '#F0E442'
wrongly = '#D55E00'
set border 1
set xtics out
unset grid; set grid x lc rgb '#dddddd' lw 0.7 dt 1
unset key
of(name) = 100.0*column(name)/column('all')
half = 0.17

# What the colours mean.
y0 = 1 - 20.0/tall
d = 9.0/tall
do for [k=1:3] {
  x = word('0.03 0.36 0.62', k) + 0
  set object 10 + k rectangle from screen x,y0-d to screen x+0.03,y0+d fc rgb word(by_right.' '.by_luck.' '.wrongly, k) fs solid 1.0 border rgb '#202020'
  set label 10 + k word('removed_by_right by_luck wrongly', k) at screen x+0.045,y0 left textcolor rgb '#202020'
}
set label 11 'removed by right'
set label 12 'by luck'
set label 14 'upper bars as printed, lower bars mended' at screen 0.03,1 - 52.0/tall left textcolor rgb '#202020'

set tmargin at screen 1 - 68.0/tall; set bmargin at screen 1 - 690.0/tall
set xrange [0:*]
set yrange [7.6:-0.6]
set ytics scale 0 ('figure 5.6, apart' 0, 'figure 5.6, touching' 1, 'wall, apart' 2, 'wall, touching' 3, \
  "random piles,\nupright" 4, "random piles,\nsome tilted" 5, "5 rows,\nknocked" 6, "3 rows,\nwhich fall" 7)
set xlabel 'unknown forces removed [% of all]' offset 0,0.3
place(r) = column('group') + (r == 0 ? -0.19 : 0.19)
bar(name, r) = column('reading') == r && column('group') < 8 && column(name) > 0 ? 0.5*of(name) : NaN
plot for [r=0:1] stem.'.csv' using (bar('granted', r)):(place(r)):(bar('granted', r)):(half) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb by_right, \
  for [r=0:1] '' using (of('granted') + bar('lucky', r)):(place(r)):(bar('lucky', r)):(half) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb by_luck, \
  for [r=0:1] '' using (of('granted') + of('lucky') + bar('wrong', r)):(place(r)):(bar('wrong', r)):(half) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb wrongly
unset object; unset label

# Each erratum by itself, on all random piles.
set label 14 'random piles: mended, but for one erratum' at screen 0.03,1 - 806.0/tall left textcolor rgb '#202020'
set tmargin at screen 1 - 824.0/tall; set bmargin at screen 85.0/tall
set yrange [5.7:0.4]
set ytics scale 0 ('all mended' 1, 'G2: one body cleared' 2, 'G3: order decides' 3, 'G4: walls cleared' 4, \
  'G8: exact equality' 5)
kept(name) = column('reading') > 0 && column('group') == 8 && column(name) > 0 ? 0.5*of(name) : NaN
plot stem.'.csv' using (kept('granted')):'reading':(kept('granted')):(0.3) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb by_right, \
  '' using (of('granted') + kept('lucky')):'reading':(kept('lucky')):(0.3) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb by_luck, \
  '' using (of('granted') + of('lucky') + kept('wrong')):'reading':(kept('wrong')):(0.3) with boxxyerror fs solid 1.0 border rgb '#202020' lw 0.7 dt 1 lc rgb wrongly
