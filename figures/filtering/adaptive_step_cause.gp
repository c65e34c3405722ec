# Chatter against the step, for pushes of several sizes and for none.
tall = 980
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set logscale x 2
set xrange [0.02:0.0035]
set xtics ('1/60' 1.0/60, '1/120' 1.0/120, '1/240' 1.0/240)

set key at screen 0.56,0.985 center top vertical maxrows 2 width -1
set tmargin at screen 0.9; set bmargin at screen 0.53
set logscale y; set yrange [0.005:5]; set format y '%g'
side = 'amplitude at rest [mm]'; @SIDE
plot stem.'.csv' using 'step_s':'push_mm' with linespoints lt 1 title 'push of L/1000', \
  '' using 'step_s':'quarter_mm' with linespoints lt 2 title 'push of L/4000', \
  '' using 'step_s':'shrinking_mm' with linespoints lt 3 title 'push as step²', \
  '' using 'step_s':'velocity_mm' with linespoints lt 4 title 'no push'
unset key

set tmargin at screen 0.46; set bmargin at screen 0.1
unset logscale y; set yrange [0:1.05]; set ytics 0,0.25
side = 'bodies that rest'; @SIDE
set xlabel 'step [s]' offset 0,0.3
plot stem.'.csv' using 'step_s':'push_resting' with linespoints lt 1, \
  '' using 'step_s':'quarter_resting' with linespoints lt 2, \
  '' using 'step_s':'shrinking_resting' with linespoints lt 3, \
  '' using 'step_s':'velocity_resting' with linespoints lt 4
