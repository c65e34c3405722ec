# One die with restitution and without: height of the lowest corner; bounces of all dice.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.89; set bmargin at screen 0.53
set xrange [0:*]
set yrange [-0.1:*]; set ytics 0.5  # what rests is seen above the axis
set xlabel 'time [s]' offset 0,0.3
side = 'height [m]'; @SIDE
plot stem.'_path.csv' using 'time_s':'height_m' with lines lt 1 title 'slow collisions stick', \
  '' using 'time_s':'height_all_m' with lines lt 2 title 'all collisions stick'

unset key
set tmargin at screen 0.42; set bmargin at screen 0.105
set xrange [0.4:*]; set xtics 1,3
set yrange [-0.5:*]; set ytics 2
set xlabel 'die'
side = 'bounces'; @SIDE
plot stem.'.csv' using 'seed':'bounces' with points lt 1 ps 1.2, \
  '' using 'seed':'bounces_all' with points lt 2 ps 1.2
