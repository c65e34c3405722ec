# Drift of a pyramid under shock propagation, for three restitutions of the sweeps over a level.
tall = 500
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.8; set bmargin at screen 0.2
set logscale y
set format y powers
set key at screen 0.56,0.985 center top vertical maxcols 1
set xlabel 'rows' offset 0,0.3
set xrange [3.5:10.5]; set xtics 1
side = 'farthest drift / mm'; @SIDE
plot stem.'.csv' using 'rows':'constant_mm' with linespoints lt 1 title 'constant, as printed', \
  '' using 'rows':'shock_mm' with linespoints lt 2 title 'rising in shock propagation', \
  '' using 'rows':'rising_mm' with linespoints lt 3 title 'rising in all sweeps'
