# Lines of code of three techniques, and random piles that each runs through.
tall = 620
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
unset key
set xrange [0.5:3.5]; set xtics ('impulse' 1, 'analytic' 2, 'time\_stepping' 3)
set yrange [0:*]
set boxwidth 0.5
set style fill solid 0.8
set tmargin at screen 0.96; set bmargin at screen 0.6
side = 'lines with code'; @SIDE
plot stem.'.csv' using 'technique':'lines' with boxes lt 1
set tmargin at screen 0.46; set bmargin at screen 0.1
side = 'piles run through'; @SIDE
plot stem.'.csv' using 'technique':'through' with boxes lt 3
