# The longest stable step against the edge of a cell; steps per second of six runs before and after cracks.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.90; set bmargin at screen 0.62
set logscale xy; set format y powers
set xrange [0.01:0.06]; set xtics ('1.25' 0.0125, '2.5' 0.025, '5' 0.05); unset mxtics
set yrange [5e-7:1e-3]
set xlabel 'edge of a cell [cm]' offset 0,0.4
set key at screen 0.56,0.99 center top vertical maxrows 2 samplen 1.5
side = 'step [s]'; @SIDE
steps = stem.'_steps.csv'
of(low, high, name) = column('young_Pa') > low && column('young_Pa') < high ? column(name) : NaN
plot steps using 'cell_m':(of(1e8, 1e9, 'found_s')) with points lt 1 title 'soft, longest', \
  '' using 'cell_m':(of(1e8, 1e9, 'courant_s')) with lines lt 1 title 'soft, Courant', \
  '' using 'cell_m':(of(5e10, 1e11, 'found_s')) with points lt 2 title 'glass, longest', \
  '' using 'cell_m':(of(5e10, 1e11, 'courant_s')) with lines lt 2 title 'glass, Courant'
unset logscale x; set format x '%g'
set tmargin at screen 0.42; set bmargin at screen 0.12
set xrange [0.5:6.5]; set yrange [5e3:5e6]
set xtics ('plank' 1, 'wall' 2, 'plank' 3, 'wall' 4, 'plank' 5, 'wall' 6)
set xlabel ' '
set label 1 'glass' at 1.5,graph -0.2 center
set label 2 'concrete' at 3.5,graph -0.2 center
set label 3 'soft' at 5.5,graph -0.2 center
set key at screen 0.56,0.49 center top vertical maxrows 1 samplen 1.5
side = 'steps per second'; @SIDE
set boxwidth 0.35
place(k) = 2*(column('material') - 1) + column('scene') + k
plot stem.'.csv' using (place(-0.18)):'start' with boxes fs solid 0.5 lt 1 title 'before the first crack', \
  '' using (place(0.18)):'worst' with boxes fs solid 0.8 lt 2 title 'worst mesh', \
  1e6 with lines lt 8 notitle
