# Work of full timewarp for a collision against the length of its flights.
tall = 940
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
numbers = stem.'.csv'
stats numbers using 'between' name 'between' nooutput
unset key
set logscale x 2
set xrange [0.42:76]; set xtics (0.5, 1, 2, 4, 8, 16, 32, 64)
set format x ''
set arrow 1 from between_mean,graph 0 to between_mean,graph 1 nohead lt 8 dt (6,4)
set label 1 'from one collision of' at between_mean,graph 0.9 left offset 0.5,0 textcolor rgb soft
set label 2 'a body to its next' at between_mean,graph 0.8 left offset 0.5,0 textcolor rgb soft

set tmargin at screen 0.975; set bmargin at screen 0.69
set yrange [0:40]; set ytics 0,10
side = 'integrations per collision'; @SIDE
plot numbers using 'stride':'integrations' with lines lt 1, \
  '' using 'stride':'integrations':'integrations_low':'integrations_high' with yerrorbars lt 1
unset label 1; unset label 2

set tmargin at screen 0.665; set bmargin at screen 0.38
set yrange [0:500]; set ytics 0,100
side = 'pair tests per collision'; @SIDE
plot numbers using 'stride':'pair_tests' with lines lt 1, \
  '' using 'stride':'pair_tests':'pair_tests_low':'pair_tests_high' with yerrorbars lt 1

set tmargin at screen 0.355; set bmargin at screen 0.095
set format x '%g'
set xlabel 'length of a flight, in frames' offset 0,0.3
set yrange [0:1.5]; set ytics 0,0.5
side = 'taken back per collision'; @SIDE
plot numbers using 'stride':'taken_back' with lines lt 1, \
  '' using 'stride':'taken_back':'taken_back_low':'taken_back_high' with yerrorbars lt 1
