# Passes that one contact at a time needs for a stack, and how well their rate is known.
tall = 720
@PAGE
set multiplot
stats stem.'.csv' using 'boxes' name 'stack' nooutput
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale xy
set xrange [1.8:1.1*stack_max]
set xtics (2, 3, 5, 10, 20, 40)
set format y powers

set tmargin at screen 0.93; set bmargin at screen 0.46
set format x ''
set yrange [5:*]
side = 'passes'; @SIDE
set label 1 'ten passes, as is usual' at graph 0.98,first 10 right offset 0,0.7 textcolor rgb soft
set key at screen 0.56,0.985 center top horizontal
plot 10 with lines lt 8 notitle, \
  stem.'.csv' using 'boxes':'predicted' with lines lt 1 title 'closed form', \
  '' using 'boxes':'passes' with points lt 2 title 'counted'
unset label 1

unset key
set tmargin at screen 0.40; set bmargin at screen 0.13
set format x '%g'
set xlabel 'boxes in the stack'
side = 'error of the rate'; @SIDE
set yrange [1e-17:1e-10]; set ytics 1e-16,1e2
set ytics add ('0' 1e-17)
set label 2 'accepted' at graph 0.98,first 1e-12 right offset 0,0.7 textcolor rgb soft
plot stem.'.csv' using 'boxes':'accepted' with lines lt 8, \
  '' using 'boxes':(column('error') > 0 ? column('error') : 1e-17) with points lt 2
