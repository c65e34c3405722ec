# Error of the height after a fall, against the step.
tall = 580
@PAGE
set lmargin at screen 0.18; set rmargin at screen 0.95
set tmargin at screen 0.80; set bmargin at screen 0.16
floor = 1e-18
shown(error) = abs(error) > floor ? abs(error) : floor
set logscale xy
set format x powers; set format y powers
set yrange [floor:10]; set ytics 1e-16,1e4
set ytics add ('0' floor)
set xlabel 'step [s]'
side = 'error of the height [m]'; @SIDE
set key at screen 0.56,0.985 center top vertical maxcols 1
plot stem.'.csv' using 'step_s':'predicted_m' with lines lt 8 title 'g t h/2', \
  '' using 'step_s':(shown(column('forward_m'))) with points lt 2 ps 1.6 title 'forward Euler', \
  '' using 'step_s':(shown(column('semi_implicit_m'))) with points lt 3 title 'semi-implicit Euler', \
  '' using 'step_s':(shown(column('ballistic_m'))) with points lt 1 title 'parabola'
