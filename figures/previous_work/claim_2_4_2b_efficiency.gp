# Motions that chains and chance try until a wish is met, by wish.
tall = 420
@PAGE
set lmargin at screen 0.2; set rmargin at screen 0.95
set tmargin at screen 0.84; set bmargin at screen 0.19
set xrange [0.5:20.5]; set xtics (1, 5, 10, 15, 20); set logscale y; set yrange [10:2000]
set xlabel 'wish' offset 0,0.4
side = 'motions tried'; @SIDE
set key at screen 0.56,0.985 center top horizontal
plot stem.'.csv' using 'wish':(column('chance')/8) with points lt 1 ps 1.6 title 'independent noise', \
  '' using 'wish':(column('chains')/8) with points lt 2 ps 1.6 title 'chains'
