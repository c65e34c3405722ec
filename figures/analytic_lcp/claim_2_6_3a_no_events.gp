# Overlap and error of a run without events.
tall = 760
@PAGE
numbers = stem.'.csv'
set multiplot
set lmargin at screen 0.19; set rmargin at screen 0.95
set tmargin at screen 0.96; set bmargin at screen 0.59
set logscale y
set yrange [1e-15:30]
set ytics 1e-15,1e3
set format y powers
set key off
side = 'overlap over size [%]'; @SIDE
set label 1 '1 %' at graph 0.02,first 0.03 textcolor rgb soft
plot numbers using 'time_s':(1.0) with lines lt 8, \
  '' using 'time_s':(column('overlap_percent') < 2e-15 ? 2e-15 : column('overlap_percent')) with points lt 1
set tmargin at screen 0.51; set bmargin at screen 0.145
set yrange [1e-17:1e-5]
set ytics 1e-17,1e2
side = 'error of velocities'; @SIDE
set label 1 'accepted' at graph 0.02,first 6e-7 textcolor rgb soft
set xlabel 'time [s]'
plot numbers using 'time_s':(1e-7) with lines lt 8, \
  '' using 'time_s':'error' with points lt 2
unset multiplot
