# Error of the motion against steps of Faure's iteration and sweeps of Gauss-Seidel, in motion and at rest.
tall = 520
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.82; set bmargin at screen 0.15
set logscale y; set format y powers
set xrange [0:105]; set yrange [1e-8:2]; set ytics 1e-8,100
set xlabel 'steps, or sweeps'
side = 'error of the motion'; @SIDE
set key at screen 0.56,0.985 center top vertical maxrows 2
set arrow 1 from 0,0.01 to 105,0.01 nohead lt 8 dt (2,4)
set label 1 'one per cent' at 104,0.01 right offset 0,0.6 textcolor rgb soft
plot stem.'.csv' using 'steps':'faure' with linespoints lt 1 title 'Faure, in motion', \
  '' using 'steps':'faure_rest' with linespoints lt 1 dt 2 pt 6 title 'at rest', \
  '' using 'steps':'sweeps' with linespoints lt 2 title 'sweeps, in motion', \
  '' using 'steps':'sweeps_rest' with linespoints lt 2 dt 2 pt 4 title 'at rest'
