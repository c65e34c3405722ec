# How boxes of random piles accelerate under loads on all tops: shares up to a ratio.
tall = 600
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.80; set bmargin at screen 0.17
set key at screen 0.56,0.985 center top vertical maxcols 1 samplen 3
set logscale x
set xrange [1e-17:1e4]
set xtics 1e-16,1e4,1e4 format powers
set yrange [0:1.04]; set ytics 0,0.25,1
set xlabel 'acceleration over that by the load alone' offset 0,0.1
side = 'fraction of boxes below it'; @SIDE
set object 1 rectangle from 1e-17,graph 0 to 1e-9,graph 1 fc rgb '#d9efe6' fs solid noborder behind
set object 2 rectangle from 1e-6,graph 0 to 1e4,graph 1 fc rgb '#f7e6da' fs solid noborder behind
set label 1 'rounding' at 1e-10,graph 0.06 right textcolor rgb soft
set label 2 'moves' at 2e-6,graph 0.06 left textcolor rgb soft
plot stem.'_stable.csv' using 'ratio':'share' with steps lt 1 lw 5 title 'stable by the thesis''s rule, as meant', \
  stem.'_load_proof.csv' using 'ratio':'share' with steps lt 3 title 'load-proof, and not stable by the rule', \
  stem.'_printed.csv' using 'ratio':'share' with steps lt 2 title 'stable by the listing as printed', \
  stem.'_other.csv' using 'ratio':'share' with steps lt 4 title 'not stable by the rule'
