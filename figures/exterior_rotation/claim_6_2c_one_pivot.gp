# The joint between nested spins after one step: own twists against the formula, and other ways to move.
tall = 1200
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955
of(s, name) = column('spins') == s ? column(name) : NaN
stats stem.'_spins.csv' using (column('tree_m') > 1e-17 ? column('tree_m') : 0) every ::1 nooutput
tree = STATS_max

set key at screen 0.56,0.993 center top vertical maxrows 2 width -4 title 'spins of lower and upper box [rad/s]'
set logscale xy; set format y powers
set xrange [0.00045:0.055]; set xtics (0.0005, 0.002, 0.01, 0.05); set format x ''
set tmargin at screen 0.925; set bmargin at screen 0.67
set yrange [1e-8:0.1]; set ytics 1e-8,100
side = 'mismatch [m]'; @SIDE
plot for [s=1:4] stem.'.csv' using 'step_s':(of(s, 'predicted_m')) with lines lt 8 notitle, \
  '' using 'step_s':(of(1, 'measured_m')) with points lt 1 ps 1.0 title '-1.5 and 1.5 (figure 6.3)', \
  '' using 'step_s':(of(2, 'measured_m')) with points lt 2 ps 1.0 title '-1.5 and -1', \
  '' using 'step_s':(of(3, 'measured_m')) with points lt 3 ps 1.1 title '-6 and 2', \
  '' using 'step_s':(of(4, 'measured_m')) with points lt 4 ps 1.1 title '-0.3 and 9'
unset key

set tmargin at screen 0.64; set bmargin at screen 0.52
set format x '%g'
set xlabel 'length of the step [s]' offset 0,0.3
unset logscale y; set format y '%g'
set yrange [0.992:1.004]; set ytics 0.992,0.004
side = 'over predicted'; @SIDE
plot stem.'.csv' using 'step_s':(1) with lines lt 8 notitle, \
  for [s=1:4] '' using 'step_s':(of(s, 'ratio')) with points lt s ps 1.0 notitle

set tmargin at screen 0.355; set bmargin at screen 0.08
set key at screen 0.56,0.435 center top vertical maxrows 2 width -4 title 'one step, moved by'
unset logscale x; set xrange [-10:10]; set xtics -10,5
set logscale y; set format y powers
set yrange [3e-7:0.05]; set ytics 1e-6,10
set xlabel 'spin of the upper box [rad/s]' offset 0,0.3
side = 'mismatch [m]'; @SIDE
set label 1 sprintf('tree of pivots: %.0g m', tree) at graph 0.98,0.05 right textcolor rgb soft
set arrow 1 from first 1.5,graph 0.13 to first 1.5,graph 1 nohead lt 8 dt (6,4)
set label 2 'figure 6.3' at first 2.1,graph 0.95 left textcolor rgb soft
plot stem.'_spins.csv' using 'upper_rad_s':'straight_m' with lines lt 2 title 'straight lines', \
  '' using 'upper_rad_s':'pivot_m' with lines lt 4 title 'rotation of the lower box', \
  '' using 'upper_rad_s':'best_m' with lines lt 3 lw 3 title 'best single rotation', \
  '' using 'upper_rad_s':'own_m' with lines lt 1 title 'one twist each'
