# Visible collisions that the end-of-step test misses, against the depth that counts as visible.
tall = 840
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale x
set xrange [0.09:11]
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lt 8 dt (6,4)

set tmargin at screen 0.91; set bmargin at screen 0.50
set format x ''
set yrange [0:1.25]; set ytics 0,0.25
side = 'missed [%]'; @SIDE
set label 1 'decides' at 1,1.12 right offset -0.7,0 textcolor rgb soft
set arrow 2 from graph 0,first 1 to graph 1,first 1 nohead lt 8 dt (2,4)
set label 2 'refuted above' at graph 0.98,first 1 right offset 0,0.7 textcolor rgb soft
set key at screen 0.56,0.985 center top horizontal
up(x) = x > 0 ? 100*x : 0
plot stem.'.csv' using (100*column('depth')):(100*column('clump')) with lines lt 1 title 'clump', \
  '' using (100*column('depth')):(100*column('clump')):(up(column('clump_low'))):(up(column('clump_high'))) with yerrorbars lt 1 notitle, \
  '' using (100*column('depth')):(100*column('pyramid')) with lines lt 2 title 'pyramid', \
  '' using (104*column('depth')):(100*column('pyramid')):(up(column('pyramid_low'))):(up(column('pyramid_high'))) with yerrorbars lt 2 notitle
unset label 1; unset label 2; unset arrow 2

set tmargin at screen 0.41; set bmargin at screen 0.115
set format x '%g'
set xlabel 'overlap that counts as visible [% of the size]'
set logscale y
set yrange [0.5:1e5]; set ytics 1,10; set format y powers
side = 'collisions, both'; @SIDE
set key at screen 0.56,0.475 center top horizontal
plot stem.'.csv' using (100*column('depth')):'collisions' with linespoints lt 3 title 'as deep or deeper', \
  '' using (100*column('depth')):'missed' with linespoints lt 4 title 'of these, missed'
