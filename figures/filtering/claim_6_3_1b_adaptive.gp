# The clump with fixed and with adaptive steps: bodies that move, sub-steps, amplitudes of bodies at rest.
tall = 1200
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
amplitudes = stem.'_amplitudes.csv'

set key at screen 0.56,0.985 center top horizontal
set tmargin at screen 0.935; set bmargin at screen 0.705
set xrange [0:*]; set xtics 0,1
set yrange [0:1.05]; set ytics 0,0.25
side = 'bodies that still move'; @SIDE
plot stem.'.csv' using 'time_s':'fixed' with lines lt 1 title 'steps of 1/60 s', \
  '' using 'time_s':'adaptive' with lines lt 2 title 'adaptive'
unset key

set tmargin at screen 0.64; set bmargin at screen 0.475
side = 'sub-steps in a step'; @SIDE
set logscale y 2; set yrange [0.9:*]; set ytics 1,2
set xlabel 'time [s]' offset 0,0.3
plot stem.'.csv' using 'time_s':(1) with lines lt 1, '' using 'time_s':'substeps' with lines lt 2
unset logscale y

set tmargin at screen 0.365; set bmargin at screen 0.085
side = 'of the bodies at rest'; @SIDE
set label 1 'fraction that shakes by as much or more' at graph 0.98,1.06 right textcolor rgb '#202020'
set logscale x
set xrange [0.01:10]; set xtics (0.01, 0.1, 1, 10)
set yrange [0:1.02]; set ytics 0,0.25
set xlabel 'amplitude [mm]; edges are 1 m' offset 0,0.3
plot amplitudes using 'amplitude_mm':'fixed' with lines lt 1, \
  '' using 'amplitude_mm':'adaptive' with lines lt 2
