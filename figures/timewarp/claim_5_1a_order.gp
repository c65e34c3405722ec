# Share of wrong frames against the way in a frame: crowded cages and chains.
tall = 1240
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set logscale x 2
set xrange [0.21:9.6]
set xtics ('1/4' 0.25, '1/2' 0.5, '1' 1, '2' 2, '4' 4, '8' 8)
set yrange [-0.03:1.05]; set ytics 0,0.25
set style fill solid 1.0 noborder
set object 1 rectangle from first 0.42,graph 0 to first 4.75,graph 1 fc rgb '#eeeeee' fs solid noborder behind
chains = stem.'_chains.csv'

set tmargin at screen 0.92; set bmargin at screen 0.69
side = 'wrong frames'; @SIDE
set label 1 'a cage of cubes; grey: decides' at graph 0.5,1.09 center textcolor rgb '#202020'
set key at screen 0.56,0.99 center top horizontal maxcols 3 width -1
plot stem.'.csv' using 'way':'simple' with linespoints lt 1 title 'simple', \
  '' using 'way':'simple':'simple_low':'simple_high' with yerrorbars lt 1 notitle, \
  '' using 'way':'safer' with linespoints lt 2 title 'safer', \
  '' using 'way':'safer':'safer_low':'safer_high' with yerrorbars lt 2 notitle, \
  '' using 'way':'swept' with linespoints lt 3 title 'swept', \
  '' using 'way':'swept':'swept_low':'swept_high' with yerrorbars lt 3 notitle
unset key

set tmargin at screen 0.645; set bmargin at screen 0.415
side = 'wrong events'; @SIDE
unset label 1
set xlabel 'largest relative distance in a frame [edges]' offset 0,0.3
plot stem.'.csv' using 'way':'simple_events' with linespoints lt 1, \
  '' using 'way':'simple_events':'simple_events_low':'simple_events_high' with yerrorbars lt 1, \
  '' using 'way':'safer_events' with linespoints lt 2, \
  '' using 'way':'safer_events':'safer_events_low':'safer_events_high' with yerrorbars lt 2, \
  '' using 'way':'swept_events' with linespoints lt 3, \
  '' using 'way':'swept_events':'swept_events_low':'swept_events_high' with yerrorbars lt 3

unset object 1
set tmargin at screen 0.305; set bmargin at screen 0.08
side = 'wrong chains'; @SIDE
set label 1 'five cubes on a line' at graph 0.5,1.09 center textcolor rgb '#202020'
set label 2 'up to here simple is right' at 2,0.55 right offset -0.7,0 textcolor rgb soft
set arrow 1 from 2,graph 0 to 2,graph 1 nohead lt 8 dt (6,4)
plot chains using 'way':'simple' with linespoints lt 1, \
  '' using 'way':'simple':'simple_low':'simple_high' with yerrorbars lt 1, \
  '' using 'way':'safer' with linespoints lt 2, \
  '' using 'way':'safer':'safer_low':'safer_high' with yerrorbars lt 2, \
  '' using 'way':'swept' with linespoints lt 3, \
  '' using 'way':'swept':'swept_low':'swept_high' with yerrorbars lt 3
