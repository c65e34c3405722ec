# Multiplications of contact forces and of least constraint against contacts per body.
tall = 560
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.93
set tmargin at screen 0.84; set bmargin at screen 0.17
set logscale y; set format y powers; set ytics 10,10
set yrange [10:1e9]
set xlabel 'contacts on a box'
side = 'multiplications'; @SIDE
set key at screen 0.55,0.985 center top vertical maxcols 2
set label 1 '10 boxes' at graph 0.99,first 1.6e6 right textcolor rgb soft
set label 2 '4 boxes' at graph 0.99,first 6e4 right textcolor rgb soft
set label 3 '1 box' at graph 0.99,first 1.1e3 right textcolor rgb soft
plot stem.'.csv' using 'contacts':'forces_10' with lines lt 1 title 'contact forces', \
  '' using 'contacts':'least_10' with lines lt 2 title 'least constraint', \
  '' using 'contacts':'forces_4' with lines lt 1 notitle, \
  '' using 'contacts':'least_4' with lines lt 2 notitle, \
  '' using 'contacts':'forces_1' with lines lt 1 notitle, \
  '' using 'contacts':'least_1' with lines lt 2 notitle
