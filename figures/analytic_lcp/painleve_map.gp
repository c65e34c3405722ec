# Painlevé's rod: the number of forces over angle and friction, a time step's answer as dots, and the
# impulse of a step against its length.
tall = 1280
@PAGE
dot = form eq 'svg' ? 0.5 : 0.7
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
colour(answers) = answers == 0 ? 0xf2b8a0 : answers == 1 ? 0xdbe9f4 : answers == 2 ? 0xf4f4f4 : 0xf7ee9a
stats stem.'_least.csv' using 'angle_deg' name 'angle' nooutput
stats stem.'_least.csv' using 'mu' name 'least' nooutput
stats stem.'_least.csv' using 'spin_rad_s' name 'spin' nooutput
set xrange [20:88]; set xtics 10
set yrange [0:3]; set ytics 0,0.5
set format y '%.1f'
unset grid
middle(low, high) = 0.5*(column(low) + column(high))
half(low, high) = 0.51*(column(high) - column(low))  # without seams
cells = "using (middle('from_deg','to_deg')):(middle('from_mu','to_mu')):(half('from_deg','to_deg')):(0.5*(column('to_mu') - column('from_mu'))):(colour(column('answers'))) with boxxy lc rgb variable fs solid 1.0 noborder notitle"
edge = "stem.'_boundary.csv' using 'angle_deg':'mu' with lines lw 3 dt 1 lc rgb '#D55E00' notitle"
after(state) = column('after') == state ? column('mu') : NaN
dots = "stem.'.csv' using 'angle_deg':(after(2)) with points pt 7 ps dot lc rgb '#202020' title 'time step: sticks', '' using 'angle_deg':(after(1)) with points pt 6 ps dot lc rgb '#202020' title 'slides on', '' using 'angle_deg':(after(0)) with points pt 2 ps dot lc rgb '#202020' notitle"
set style textbox opaque fillcolor rgb '#ffffff' noborder margins 1,0.6

set key at screen 0.565,0.998 center top horizontal maxrows 1 samplen 0.5 width -3
set label 3 'without spin' at screen 0.565,0.962 center textcolor rgb '#202020'
set label 4 'no solution' at 60,2.2 center boxed front textcolor rgb '#202020'
set label 5 'one solution' at 42,0.6 center boxed front textcolor rgb '#202020'
set label 6 sprintf('%.3f at %.1f°', least_max, angle_max) at angle_max,least_max center boxed front offset 0,-0.9 textcolor rgb '#202020'
set tmargin at screen 0.95; set bmargin at screen 0.685
set format x ''
side = 'friction μ'; @SIDE
plot stem.'_still.csv' @cells, @edge, @dots, \
  stem.'_least.csv' using 'angle_deg':'mu' with points pt 7 ps 1.3 lc rgb '#D55E00' notitle

unset key; unset label 6
set label 3 sprintf('spinning with %g rad/s', spin_max) at screen 0.565,0.644
set label 4 'two solutions'
set label 5 'one solution: it lifts off'
set label 7 'one solution' at 21.5,1.5 center rotate boxed front textcolor rgb '#202020'
set tmargin at screen 0.632; set bmargin at screen 0.367
set format x '%g°'
set xlabel 'angle of the rod θ' offset 0,0.4
plot stem.'_spinning.csv' @cells, @edge, @dots

unset label 3; unset label 4; unset label 5; unset label 7
@AXES
set tmargin at screen 0.27; set bmargin at screen 0.065
set logscale xy
set xrange [8e-6:0.12]; set xtics 1e-6,10
set yrange [1e-4:3]; set ytics 1e-6,10
set format x powers; set format y powers
set xlabel 'time step [s]'
set label 8 'above the curve (μ = 1.5)' at 1.2e-5,0.9 textcolor rgb '#D55E00'
set label 9 'below it (μ = 1)' at 1.6e-4,1.4e-3 textcolor rgb '#0072B2'
# The rod.
set arrow 1 from graph 0.68,0.07 to graph 0.97,0.07 nohead lc rgb '#808080' lw 2
set arrow 2 from graph 0.80,0.07 to graph 0.88,0.315 nohead lc rgb '#303030' lw 6
set arrow 3 from graph 0.785,0.12 to graph 0.70,0.12 head size graph 0.015,25 filled lc rgb '#303030' lw 2
set label 10 'θ' at graph 0.84,0.12 textcolor rgb '#202020'
side = 'impulse [N s]'; @SIDE
plot stem.'_impulses.csv' using 'step_s':'sliding_n_s' with linespoints lt 1, \
  '' using 'step_s':'jammed_n_s' with linespoints lt 2
