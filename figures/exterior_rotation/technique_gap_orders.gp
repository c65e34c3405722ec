# Gap of figure 6.1's column against the step, by technique, on log axes.
tall = 720
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.83; set bmargin at screen 0.115
set logscale xy; set format y powers; unset mytics; unset mxtics
set xrange [0.007:0.04]; set xtics ('1/120' 1.0/120, '1/60' 1.0/60, '1/30' 1.0/30)
set yrange [2e-5:1e-2]
set xlabel 'step [s]' offset 0,0.3
side = 'largest opening or overlap [m]'; @SIDE
set key at screen 0.55,0.99 center top vertical maxrows 3 width -2
plot stem.'.csv' using 'step_s':'one_step_m' with lines lc rgb '#a0a0a0' lw 5 title 'made in one step', \
  '' using 'step_s':'glued_m' with linespoints lt 1 title 'glued, impulses', \
  '' using 'step_s':'impulse_m' with linespoints lt 2 title 'impulse, 100 passes', \
  '' using 'step_s':'stepping_m' with linespoints lt 3 title 'time\_stepping', \
  '' using 'step_s':'damped_m' with linespoints lt 4 title 'contact\_damped', \
  '' using 'step_s':'analytic_m' with linespoints lt 5 title 'analytic'
