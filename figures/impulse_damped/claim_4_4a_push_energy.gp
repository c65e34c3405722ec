# Energy after pushes out of overlap, and its kinetic part against the depth.
tall = 960
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set key at screen 0.565,0.99 center top vertical maxcols 1
set tmargin at screen 0.855; set bmargin at screen 0.585
set xrange [0:0.2]
set yrange [-0.02:0.4]; set ytics 0.1; set xtics 0.05
set xlabel 'time after the pass [s]'
side = 'energy [J]'; @SIDE
plot stem.'.csv' using 'time_s':'potential_J' with lines lt 1 title 'potential, after pushes', \
  '' using 'time_s':'kinetic_J' with lines lt 2 title 'kinetic, after pushes', \
  '' using 'time_s':'potential_ours_J' with lines lt 3 title 'potential, after our repair', \
  '' using 'time_s':'kinetic_stopped_J' with lines lt 4 title 'both, velocities stopped'

set key at screen 0.565,0.485 center top vertical maxcols 1
set tmargin at screen 0.415; set bmargin at screen 0.14
set xlabel 'largest overlap of two cubes [m]'
set logscale x; set format x powers
set xrange [7e-5:0.15]; set xtics autofreq
set yrange [-0.01:0.25]
side = 'kinetic over added'; @SIDE
set arrow 1 from 9.81/3600,graph 0 to 9.81/3600,graph 1 nohead lt 8 dt (6,4)
set label 1 'one step of gravity' at 9.81/3600,graph 0.12 right offset -0.6,0 textcolor rgb soft
plot stem.'_depth.csv' using 'depth_m':'ratio' with linespoints lt 2 title 'pushes', \
  '' using 'depth_m':'ratio_ours' with linespoints lt 3 title 'our repair'
unset multiplot
