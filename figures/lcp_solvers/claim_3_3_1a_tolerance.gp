# How the loop ends, against its tolerance.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.93
set logscale x; set xrange [1e-17:1e-3]; set yrange [0:1.02]; set ytics 0.25
set xtics ('0' 1e-17, '10^{-15}' 1e-15, '10^{-12}' 1e-12, '10^{-9}' 1e-9, '10^{-6}' 1e-6, '10^{-3}' 1e-3)
set tmargin at screen 0.86; set bmargin at screen 0.54
side = 'stacks'; @SIDE
set key at screen 0.55,0.985 center top vertical maxcols 2
set arrow 1 from 1e-5,0 to 1e-5,1.02 nohead lt 8 dt (2,4)
plot stem.'.csv' using 'eps':'solved' with linespoints lt 1 title 'ended', \
  '' using 'eps':'cap' with linespoints lt 2 title 'not after 50 (n + 1) pivots', \
  '' using 'eps':'infeasible' with linespoints lt 3 title 'force without end', \
  '' using 'eps':'singular' with linespoints lt 4 title 'division by 0'
unset key
set tmargin at screen 0.46; set bmargin at screen 0.135
side = 'contacts given twice'; @SIDE
set xlabel 'tolerance [m/s²]'
plot stem.'_repeated.csv' using 'eps':'solved' with linespoints lt 1, \
  '' using 'eps':'cap' with linespoints lt 2, '' using 'eps':'infeasible' with linespoints lt 3, \
  '' using 'eps':'singular' with linespoints lt 4
unset multiplot
