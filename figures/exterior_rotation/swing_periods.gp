# Periods of two boxes that swing on an edge, on the closed form; below, the error.
tall = 820
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:180]; set xtics 0,30; set format x ''

set tmargin at screen 0.915; set bmargin at screen 0.42
set yrange [1.5:6.4]; set ytics 2,1
side = 'period [s]'; @SIDE
set key at screen 0.55,0.99 center top vertical maxrows 2 width -2
plot stem.'_exact.csv' using 'amplitude_deg':'cube_s' with lines lt 1 dt 1 title '1 m × 1 m, exact', \
  stem.'.csv' using 'amplitude_deg':'cube_s' with points lt 1 title 'simulated', \
  stem.'_exact.csv' using 'amplitude_deg':'tall_s' with lines lt 2 dt 1 title '1 m × 2 m, exact', \
  stem.'.csv' using 'amplitude_deg':'tall_s' with points lt 2 title 'simulated'
unset key

set tmargin at screen 0.37; set bmargin at screen 0.11
set format x '%g°'
set xlabel 'swing to each side' offset 0,0.3
set logscale y; set format y powers; unset mytics
set yrange [5e-17:1e-9]; set ytics 1e-16,1e2
side = 'error over period'; @SIDE
set arrow 1 from graph 0,first 1e-11 to graph 1,first 1e-11 nohead lt 8 dt (6,4)
set label 1 'asked: 10^{-11}' at 3,4e-11 left textcolor rgb soft
above(x) = x > 1e-16 ? x : 1e-16  # many are 0
plot stem.'.csv' using 'amplitude_deg':(above(column('cube_error'))) with linespoints lt 1, \
  '' using 'amplitude_deg':(above(column('tall_error'))) with linespoints lt 2
unset multiplot
