# A bouncing cube under the basic technique: height, energy after each impact, error of its time.
tall = 860
@PAGE
set multiplot
path = stem.'_path.csv'
set lmargin at screen 0.18; set rmargin at screen 0.95
stats path using 'time_s' name 'time' nooutput
set xrange [0:1.04*time_max]

set key inside top right vertical
set tmargin at screen 0.975; set bmargin at screen 0.68
set format x ''
set yrange [0:*]
side = 'height [m]'; @SIDE
plot path using 'time_s':'height_m' with lines lt 1 notitle, \
  stem.'.csv' using 'time_s':(0) with points pt 7 ps 1 lc rgb '#D55E00' title 'impact'

set key inside bottom left
set tmargin at screen 0.635; set bmargin at screen 0.39
side = 'energy / at first'; @SIDE
set logscale y
set autoscale y
set format y '%g'
plot stem.'.csv' using 'exact_s':'exact_energy' with points pt 6 ps 1.5 lc rgb '#D55E00' title 'closed form', \
  '' using 'time_s':'energy' with points lt 1 title 'technique'

unset key
set tmargin at screen 0.345; set bmargin at screen 0.11
set format x '%g'
set xlabel 'time [s]'
side = 'error of the time [s]'; @SIDE
set ytics 1e-15,10
set format y powers
plot stem.'.csv' using 'exact_s':'accepted_s' with lines lt 8, \
  '' using 'exact_s':'accepted_s':('accepted') every ::5::5 with labels right offset -0.5,0.5 textcolor rgb soft, \
  '' using 'exact_s':'error_s' with points lt 1
