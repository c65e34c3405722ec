# The upper block of figure 5.2: its speed, and how far damping is from each coefficient of friction.
tall = 980
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.965; set bmargin at screen 0.585
set xrange [0:1]
set yrange [0:*]
set xlabel 'time [s]' offset 0,0.3
side = 'speed of A [m/s]'; @SIDE
set style fill solid 1.0 noborder
set key at graph 0.99,0.985 right top vertical maxcols 1 samplen 3
plot stem.'.csv' using 'time_s':'half_m_s':'twice_m_s' with filledcurves lc rgb '#cfe3f1' title 'half to twice the damping', \
  '' using 'time_s':'damped_m_s' with lines lt 1 title 'damped', \
  '' using 'time_s':'coulomb_m_s' with lines lt 2 title 'Coulomb, B is free', \
  '' using 'time_s':'held_m_s' with lines lt 3 title 'Coulomb, B is held'

set tmargin at screen 0.475; set bmargin at screen 0.135
set xlabel 'coefficient of friction' offset 0,0
set yrange [0:0.8]
side = 'difference, over start'; @SIDE
set key at graph 0.99,0.985 right top vertical maxcols 1 samplen 3
set object 1 rectangle from graph 0,first 0 to graph 1,first 0.1 fc rgb '#d9efe6' fs solid noborder behind
set object 2 rectangle from graph 0,first 0.3 to graph 1,first 0.8 fc rgb '#f7e6da' fs solid noborder behind
set label 1 'close' at graph 0.02,first 0.05 left textcolor rgb soft
set label 2 'another motion' at graph 0.62,first 0.52 left textcolor rgb soft
plot stem.'_friction.csv' using 'friction':'free' with lines lt 2 title 'B is free', \
  '' using 'friction':'held' with lines lt 3 title 'B is held'
