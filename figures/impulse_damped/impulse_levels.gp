# Drift of a pyramid under shock propagation against its rows; one pyramid over time; spins that one step leaves.
tall = 1240
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set logscale y
set format y powers
set key at screen 0.56,0.99 center top vertical maxcols 1
set tmargin at screen 0.9; set bmargin at screen 0.71
set xlabel 'rows' offset 0,0.3
set xrange [3.5:10.5]; set xtics 1
set yrange [*:*]
side = 'farthest drift [mm]'; @SIDE
plot stem.'.csv' using 'rows':'constant_mm' with linespoints lt 1 title 'constant, as printed', \
  '' using 'rows':'shock_mm' with linespoints lt 2 title 'rising in shock propagation', \
  '' using 'rows':'rising_mm' with linespoints lt 3 title 'rising in all sweeps'

piles = stem.'_piles.csv'
set key at screen 0.56,0.63 center top vertical maxcols 2
set tmargin at screen 0.58; set bmargin at screen 0.385
set xlabel 'time [s]' offset 0,0.3
set xrange [0:*]; set xtics 0.2
set yrange [0.1:100]
side = 'farthest drift [mm]'; @SIDE
plot piles using 'time_s':'pyramid_mm' with lines lt 1 title 'constant, as printed', \
  '' using 'time_s':'pyramid_rising_mm' with lines lt 3 title 'rising in all sweeps'

set key at screen 0.56,0.315 center top vertical maxcols 2
set tmargin at screen 0.27; set bmargin at screen 0.08
set xlabel 'row of the pyramid, from the ground up' offset 0,0.3
set xrange [0.5:10.5]; set xtics 1
set yrange [1e-5:1e-1]
side = 'spin after one step [rad/s]'; @SIDE
spins = stem.'_spins.csv'
plot spins using 'row':(column('constant') > 1e-5 ? column('constant') : NaN) with linespoints lt 1 title 'constant', \
  '' using 'row':(column('rising') > 1e-5 ? column('rising') : NaN) with linespoints lt 3 title 'rising'
