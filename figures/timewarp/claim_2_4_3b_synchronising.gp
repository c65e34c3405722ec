# Integrations of full timewarp against how often it is synchronised, and the share that is lost.
tall = 960
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
numbers = stem.'.csv'
rates = stem.'_rates.csv'
# Before there are ranges: outside of them nothing is counted.
stats numbers using 'all_larger' name 'larger' nooutput
stats numbers using 'all_smaller' name 'smaller' nooutput
stats numbers using 'full_larger' every ::0::0 name 'first' nooutput
larger_first = first_mean
stats numbers using 'full_smaller' every ::0::0 name 'first' nooutput
smaller_first = first_mean
stats rates using 'bodies' name 'bodies' nooutput
stats rates using (column('factor') == 1 && column('bodies') == bodies_max ? column('in_frame') : NaN) name 'standard' nooutput
set tmargin at screen 0.975; set bmargin at screen 0.6
unset key
set logscale xy
set xrange [0.85:19]; set xtics (1, 2, 4, 8, 'never' 16)
set xlabel 'frames from one synchronisation to the next' offset 0,0.3
set yrange [300:3e6]; set ytics 1e3,10; set format y powers
side = 'integrations [1/s]'; @SIDE
many = sprintf('%d cubes', bodies_max)
few = sprintf('%d cubes', bodies_min)
set label 1 'all rolled back, '.many at 18,larger_mean right offset 0,0.7 textcolor lt 1
set label 2 'full timewarp, '.many at 1.05,larger_first left offset 0,1 textcolor lt 1
set label 3 'all rolled back, '.few at 18,smaller_mean right offset 0,0.7 textcolor lt 2
set label 4 'full timewarp, '.few at 1.05,smaller_first left offset 0,1 textcolor lt 2
plot larger_mean with lines lt 1 dt (6,4), \
  numbers using 'frames':'full_larger' with linespoints lt 1, \
  smaller_mean with lines lt 2 dt (6,4), \
  numbers using 'frames':'full_smaller' with linespoints lt 2 dt 1
unset label 3; unset label 4

set tmargin at screen 0.455; set bmargin at screen 0.1
set xrange [0.1:100]; set xtics 0.1,10
set format y '%g'
set xlabel 'collisions in a frame'
set yrange [0.01:1]; set ytics 0.01,10
set mxtics 10; set mytics 10
side = 'fraction that is lost'; @SIDE
of(count, value) = column('bodies') == count ? value : NaN
set arrow 1 from 0.1,0.5 to 100,0.5 nohead lt 8 dt (2,4)
set arrow 2 from 0.1,0.1 to 100,0.1 nohead lt 8 dt (2,4)
set label 1 'confirmed above' at standard_mean,0.5 right offset -0.7,0.6 textcolor rgb soft
set label 2 'refuted below' at 0.1,0.1 left offset 0.7,-0.6 textcolor rgb soft
set label 3 "panel\nabove" at standard_mean,0.9 left offset 0.7,-0.3 textcolor rgb soft
set arrow 3 from standard_mean,0.01 to standard_mean,1 nohead lt 8 dt (6,4)
set key at graph 0.02,graph 0.04 left bottom vertical maxrows 3
plot 1/(1 + x) with lines lt 8 title '1/(1 + collisions)', \
  rates using 'in_frame':(of(bodies_max, column('lost'))):'lost_low':'lost_high' with yerrorbars lt 1 title many, \
  rates using 'in_frame':(of(bodies_min, column('lost'))):'lost_low':'lost_high' with yerrorbars lt 2 title few
