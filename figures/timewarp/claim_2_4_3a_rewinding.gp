# Work for a collision against the number of bodies, and its ratio against collisions in a frame.
tall = 1240
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
forms = 'all simple safer swept full'
names = '"all rolled back" "simple" "safer" "swept" "full timewarp"'
numbers = stem.'.csv'
rates = stem.'_rates.csv'
# Before there are ranges: outside of them nothing is counted.
stats rates using 'in_frame' every ::2::2 name 'standard' nooutput
set logscale xy
set xrange [7:600]
set xtics (8, 27, 64, 216, 512)
set format x ''
set key at screen 0.56,0.993 center top vertical maxrows 3 width -1

set tmargin at screen 0.915; set bmargin at screen 0.675
set yrange [1.5:1000]; set ytics 1,10
side = 'integrations for a collision'; @SIDE
plot for [k = 1:5] numbers using 'bodies':word(forms, k) with linespoints lt (k == 4 ? 6 : k == 5 ? 4 : k) title word(names, k), \
  numbers using 'bodies':'fixed' with lines lt 8 title 'flights in any frame'

set tmargin at screen 0.655; set bmargin at screen 0.415
unset key
set format x '%g'
set xlabel 'bodies' offset 0,0.3
set yrange [20:10000]; set ytics 10,10
side = 'pair tests for a collision'; @SIDE
plot for [k = 1:5] numbers using 'bodies':word(forms, k).'_tests' with linespoints lt (k == 4 ? 6 : k == 5 ? 4 : k)

set tmargin at screen 0.315; set bmargin at screen 0.075
set xrange [1:100]; set xtics 1,10; set mxtics 10
set yrange [1:100]; set ytics 1,10
set xlabel 'collisions of 512 bodies in a frame'
side = 'all rolled back over simple'; @SIDE
set arrow 1 from 1,10 to 100,10 nohead lt 8 dt (2,4)
set arrow 2 from 1,2 to 100,2 nohead lt 8 dt (2,4)
set label 1 'confirmed above' at 1.1,10 offset 0,0.6 textcolor rgb soft
set label 2 'refuted below' at 100,2 right offset -0.5,-0.6 textcolor rgb soft
set arrow 3 from standard_mean,1 to standard_mean,100 nohead lt 8 dt (6,4)
set label 3 'speeds of the' at standard_mean,5.4 left offset 0.5,0 textcolor rgb soft
set label 4 'panels above' at standard_mean,3.6 left offset 0.5,0 textcolor rgb soft
plot 512*(x + 1)/(4*x + 512) with lines lt 8, \
  rates using 'in_frame':'ratio':'ratio_low':'ratio_high' with yerrorbars lt 1
