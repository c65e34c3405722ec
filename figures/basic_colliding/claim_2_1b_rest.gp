# A cube that comes to rest under the basic technique: its height, the impacts in each step, and a
# close look at the steps around the moment of rest.
tall = 900
@PAGE
set multiplot
path = stem.'_path.csv'
cleared = stem.'_cleared.csv'
stats stem.'_rest.csv' using 'rest_s' name 'rest' nooutput
stats stem.'_rest.csv' using 'cap' name 'cap' nooutput
stats stem.'_rest.csv' using 'left_mm' name 'left' nooutput
set lmargin at screen 0.18; set rmargin at screen 0.95
set arrow 1 from rest_max,graph 0 to rest_max,graph 1 nohead lt 8 dt (6,4)
stats path using 'time_s' name 'time' nooutput
set xrange [0:time_max]

unset key
set tmargin at screen 0.98; set bmargin at screen 0.75
set format x ''
set yrange [0:*]
side = 'height [m]'; @SIDE
set label 1 'at rest' at rest_max,graph 0.9 right offset -0.7,0 textcolor rgb soft
plot path using 'time_s':'height_m' with lines lt 1
unset label 1

set key at graph 0.01,0.42 left bottom
set tmargin at screen 0.71; set bmargin at screen 0.455
set format x '%g'
side = 'impacts in a step'; @SIDE
set logscale y
set yrange [0.7:3*cap_max]
set format y '%g'
set label 2 'limit' at graph 0.01,first cap_max offset 0,0.6 textcolor rgb soft
plot cap_max with lines lt 8 notitle, \
  cleared using 'time_s':'impacts' with points pt 6 ps 1 lc rgb '#D55E00' title 'overlap lifted clear', \
  stem.'.csv' using 'time_s':'impacts' with points lt 1 title 'technique as it is', \
  '' using 'time_s':'capped' with points pt 7 ps 1.5 lc rgb '#0072B2' notitle
unset label 2
unset logscale y

unset key
set tmargin at screen 0.375; set bmargin at screen 0.1
step = 1.0/60
set xrange [rest_max-4*step:rest_max+8*step]
set yrange [-1.7:1]
set xtics 0.05
set xlabel 'time [s]' offset 0,0.3
side = 'height [mm]'; @SIDE
set label 3 'slop' at graph 0.02,first left_max offset 0,-0.6 textcolor rgb soft
set label 4 'ground' at graph 0.98,first 0 right offset 0,0.6 textcolor rgb soft
plot 0 with lines lt 8 lw 1, left_max with lines lt 8 lw 1 dt (3,3), \
  path using 'time_s':(1e3*column('height_m')) with lines lt 1
