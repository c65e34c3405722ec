# Largest gap in a second over the step, and the error of where the column is.
tall = 1070
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955
set logscale xy; set format y powers
set xrange [0.0009:0.23]; set xtics (0.001, 0.003, 0.01, 0.03, 0.1)

set key at screen 0.56,0.99 center top vertical maxrows 3 width -2
set tmargin at screen 0.905; set bmargin at screen 0.55
set yrange [1e-17:1]; set ytics 1e-16,1e3
set xlabel 'length of a step [s]' offset 0,0.3
side = 'largest gap or overlap [m]'; @SIDE
set arrow 1 from graph 0,first 1e-12 to graph 1,first 1e-12 nohead lt 8 dt (6,4)
set label 1 'asked: 10^{-12}' at graph 0.98,first 6e-12 right textcolor rgb soft
plot stem.'.csv' using 'step_s':'separate_m' with linespoints lt 2 title 'semi-implicit, separate', \
  '' using 'step_s':'semi_implicit_m' with linespoints lt 1 title 'semi-implicit, one twist', \
  '' using 'step_s':'impulse_m' with linespoints lt 5 title 'impulses, one twist', \
  '' using 'step_s':'leapfrog_m' with linespoints lt 3 title 'leapfrog', \
  '' using 'step_s':'ball_m' with linespoints lt 4 title 'leapfrog, ball joint', \
  '' using 'step_s':'flight_m' with linespoints lt 6 title 'leapfrog, in flight'
unset arrow 1; unset label 1

set tmargin at screen 0.4; set bmargin at screen 0.08
set key at screen 0.56,0.458 center top vertical maxrows 2 width -2
set yrange [1e-7:1]; set ytics 1e-7,10
side = 'error of the angle after it [rad]'; @SIDE
set label 2 'slope 1' at 0.002,3.5e-4 left textcolor rgb soft
set label 3 'slope 2' at 0.0035,6e-7 left textcolor rgb soft
plot stem.'.csv' using 'step_s':(0.45*column('step_s')) with lines lt 8 lc rgb '#b0b0b0' notitle, \
  '' using 'step_s':(0.1*column('step_s')**2) with lines lt 8 lc rgb '#b0b0b0' notitle, \
  '' using 'step_s':'semi_implicit_rad' with linespoints lt 1 title 'semi-implicit', \
  '' using 'step_s':'impulse_rad' with linespoints lt 5 title 'impulses', \
  '' using 'step_s':'leapfrog_rad' with linespoints lt 3 title 'leapfrog', \
  '' using 'step_s':'ball_rad' with linespoints lt 4 title 'leapfrog, ball joint'
