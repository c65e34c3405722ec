# Distance of a sliding box at three sizes, and differences of the motions of three scenes.
tall = 980
@PAGE
set multiplot
set lmargin at screen 0.19; set rmargin at screen 0.95
path = stem.'_path.csv'
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.78; set bmargin at screen 0.5
set xrange [0:2]; set xtics 0,0.5
set format x ''
set yrange [0:10]; set ytics 0,2
side = 'distance, in heights'; @SIDE
plot path using 'time_s':'coulomb' with lines lt 8 title 'Coulomb', \
  '' using 'time_s':'x_small' every 8 with points lt 1 pt 6 ps 1.5 title 'contact\_damped, size 0.01', \
  '' using 'time_s':'x' every 8::3 with points lt 2 pt 2 ps 1.1 title 'contact\_damped, size 1', \
  '' using 'time_s':'x_large' every 8::6 with points lt 3 pt 8 ps 1.5 title 'contact\_damped, size 100', \
  '' using 'time_s':'damped_small' with lines lt 4 title 'damped as in the thesis, size 0.01', \
  '' using 'time_s':'damped' with lines lt 5 title 'damped as in the thesis, size 1', \
  '' using 'time_s':'damped_large' with lines lt 6 title 'damped as in the thesis, size 100'

unset key
set tmargin at screen 0.455; set bmargin at screen 0.135
set format x '%g'
set xlabel 'time [s] at size 1' offset 0,0.3
set logscale y; set format y powers; unset mytics
set yrange [1e-18:1e4]; set ytics 1e4
side = 'difference, in edges'; @SIDE
set label 1 'damped as in the thesis' at 1,5e2 center textcolor rgb soft
set label 2 'contact\_damped' at 1,1e-9 center textcolor rgb soft
plot stem.'.csv' using 'time_s':'damped_small' with lines lt 4, \
  '' using 'time_s':'damped_large' with lines lt 6, \
  '' using 'time_s':(column('small') > 0 ? column('small') : NaN) with lines lt 1, \
  '' using 'time_s':(column('large') > 0 ? column('large') : NaN) with lines lt 3
