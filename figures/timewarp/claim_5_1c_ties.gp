# In which order two impacts come that are nearer in time than the tolerance.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:1.5]
set xtics 0,0.25
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lt 8 dt (6,4)

set tmargin at screen 0.84; set bmargin at screen 0.47
set yrange [-0.015:0.53]; set ytics 0,0.1
side = 'in the wrong order'; @SIDE
set label 1 'the tolerance' at 1,0.5 left offset 0.7,0 textcolor rgb soft
set key at screen 0.56,0.99 center top vertical maxcols 1
plot stem.'_bisection.csv' using 'between':'expected' with lines lt 8 title 'bisection, closed form', \
  stem.'.csv' using 'between':'simple':'simple_low':'simple_high' with yerrorbars lt 1 title 'simple', \
  '' using 'between':'turning' with lines lt 2 notitle, \
  '' using 'between':'turning':'turning_low':'turning_high' with yerrorbars lt 2 title 'swept, cubes that turn', \
  '' using 'between':'straight' with lines lt 3 notitle, \
  '' using 'between':'straight':'straight_low':'straight_high' with yerrorbars lt 3 title 'swept, cubes that do not turn'

unset label 1
set tmargin at screen 0.39; set bmargin at screen 0.115
set yrange [-0.04:1.05]; set ytics 0,0.25
set xlabel 'time between the impacts over the tolerance' offset 0,0.2
side = 'swept, ties together'; @SIDE
set key at graph 0.03,0.55 left top vertical maxcols 1
plot stem.'.csv' using 'between':'together' with linespoints lt 5 title 'at one stroke', \
  '' using 'between':'ties' with linespoints lt 4 title 'in the wrong order'
