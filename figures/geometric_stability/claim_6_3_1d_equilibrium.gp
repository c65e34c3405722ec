# Limits of figures 6.4 and 6.5 by balance, by hand and by two rules of thumb; errors of balance.
tall = 1230
@PAGE
set multiplot
m = form eq 'svg' ? 0.75 : 1  # of marks: terminals differ
set lmargin at screen 0.17; set rmargin at screen 0.955
heavy = stem.'.csv'
stairs = stem.'_stairs.csv'
edge = stem.'_edge.csv'

# Figure 6.5.
set tmargin at screen 0.895; set bmargin at screen 0.70
set xrange [-0.26:0.26]; set xtics 0.1
set yrange [0.6:1.0]; set ytics 0.1
set xlabel 'offset of the top block [m]' offset 0,0.3
side = 'mass of top over lower'; @SIDE
set key at screen 0.55,0.995 center top vertical maxcols 1 samplen 3
set label 1 'own centres: never stands' at graph 0.5,0.88 center textcolor rgb soft
plot heavy using 'offset_m':'by_hand' with lines lt 8 title 'by hand', \
  '' using 'offset_m':'middles' with linespoints lt 2 title 'loads at middles', \
  '' using 'offset_m':'balance' with points lt 1 ps m title 'balance', \
  1/0 with linespoints lt 5 title 'own centres'
unset label 1; unset key

# Figure 6.4.
set tmargin at screen 0.627; set bmargin at screen 0.43
set xrange [1.7:8.3]; set xtics 1
set yrange [0:0.6]; set ytics 0.2
set xlabel 'blocks of a staircase'
side = 'largest overhang'; @SIDE
plot stairs using 'blocks':'by_hand' with lines lt 8, \
  '' using 'blocks':'middles' with linespoints lt 2, \
  '' using 'blocks':'own' with linespoints lt 5, \
  '' using 'blocks':'balance' with points lt 1 ps m

# Errors.
set tmargin at screen 0.352; set bmargin at screen 0.075
set logscale y; set format y powers
set yrange [1e-11:1e-5]; set ytics 1e-10,100
set arrow 1 from graph 0,first 1e-6 to graph 1,first 1e-6 nohead lt 8 dt (6,4)
set rmargin at screen 0.46
set xrange [-0.26:0.26]; set xtics 0.2
set xlabel 'offset [m]'
side = 'relative error'; @SIDE
set label 1 'allowed' at graph 0.5,first 2.5e-6 center textcolor rgb soft
plot heavy using 'offset_m':'error' with points lt 1 ps m
unset label 99; unset label 1
set lmargin at screen 0.52; set rmargin at screen 0.955
set format y ''
set xrange [0.5:8.5]; set xtics 2
set xlabel 'blocks'
set key at graph 0.99,0.80 right top vertical maxcols 1 samplen 1.5
plot stairs using 'blocks':'error' with points lt 1 ps m title 'balance, stairs', \
  '' using 'blocks':'towers_error' with points lt 3 title 'towers, stairs', \
  edge using 'blocks':'error' with points lt 1 pt 6 ps 1.2*m lw 1 title 'balance, edge', \
  '' using 'blocks':'towers_error' with points lt 3 pt 8 ps 1.2*m lw 1 title 'towers, edge'
