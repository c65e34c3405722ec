# Speed of a box of rods and of a ball of one particle that fall on the ground, and stretch of a hanging chain against passes.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.2; set rmargin at screen 0.95
set key at screen 0.56,0.992 center top vertical maxrows 2
set tmargin at screen 0.9; set bmargin at screen 0.6
set xrange [0.3:0.8]; set yrange [0:4.8]
set xlabel 'time [s]' offset 0,0.4
side = 'speed [m/s]'; @SIDE
plot stem.'.csv' using 'time_s':'box' with linespoints lt 1 title 'box of rods, 10 passes', \
  '' using 'time_s':'hasty' with linespoints lt 2 title '4 passes', \
  '' using 'time_s':'ball' with linespoints lt 3 title 'a particle'
set key at screen 0.56,0.5 center top horizontal
set tmargin at screen 0.43; set bmargin at screen 0.11
set logscale xy
set xrange [0.9:70]; set xtics (1, 2, 4, 8, 16, 32, 64)
set yrange [0.0002:1]; set ytics ('0.1 %%' 0.001, '1 %%' 0.01, '10 %%' 0.1, '100 %%' 1); unset mytics
set xlabel 'passes in a step' offset 0,0.4
side = 'stretch of a hanging chain'; @SIDE
chain = stem.'_chain.csv'
plot chain using 'passes':'at_30' with linespoints lt 1 title 'steps of 1/30 s', \
  '' using 'passes':'at_60' with linespoints lt 2 title '1/60 s', \
  '' using 'passes':'at_120' with linespoints lt 3 title '1/120 s'
