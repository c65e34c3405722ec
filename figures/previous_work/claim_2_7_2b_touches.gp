# Points at which a body touches others, by heap, under two techniques.
tall = 420
@PAGE
set lmargin at screen 0.12; set rmargin at screen 0.95
set tmargin at screen 0.84; set bmargin at screen 0.19
set xrange [0.5:5.5]; set xtics 1; set yrange [0:10]
set xlabel 'pile' offset 0,0.4
side = 'points at a body'; @SIDE
set key at screen 0.56,0.985 center top horizontal
plot stem.'.csv' using 'seed':'optimised' with points lt 1 ps 1.6 title 'optimised', \
  '' using 'seed':'time_stepping' with points lt 2 ps 1.6 title 'time\_stepping'
