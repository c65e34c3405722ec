# Steps and force solves a second that keep the gap small, by scheme: bars on a log axis.
tall = 860
@PAGE
array names[11] = ['forward Euler', 'semi-implicit', 'impulses', 'midpoint', 'leapfrog', 'Runge-Kutta 4', 'Dormand-Prince', \
  'forward Euler', 'semi-implicit', 'impulses', 'leapfrog']
set lmargin at screen 0.305; set rmargin at screen 0.95
set tmargin at screen 0.9; set bmargin at screen 0.095
set logscale x
set xrange [0.5:60000]; set xtics 1,10; set format x '%g'; unset mxtics
set xlabel 'in a second of the fall' offset 0,0.3
set yrange [11.7:-0.7]
set border 1 lc rgb '#808080'; unset grid
set ytics scale 0 ('' -5)
set for [k=1:11] ytics add (names[k] (k < 8 ? k - 1 : k))
set arrow 1 from 60,graph 0 to 60,graph 1 nohead back lc rgb '#b0b0b0' lw 1.5
set label 1 '60 a second' at 60,graph 1 center offset 0,0.6 textcolor rgb soft
set label 2 'each body by its exponential:' at screen 0.03,first 7.1 left textcolor rgb soft
set key at screen 0.6,0.99 center top vertical maxrows 1 width -1
place(k) = k < 7 ? k : k + 1
set style fill solid 1 noborder
plot stem.'.csv' using (0.5):(place(column('scheme'))-0.18):(0.5):'steps':(place(column('scheme'))-0.34):(place(column('scheme'))-0.02) with boxxyerror lc rgb '#0072B2' title 'steps', \
  '' using (0.5):(place(column('scheme'))+0.18):(0.5):'solves':(place(column('scheme'))+0.02):(place(column('scheme'))+0.34) with boxxyerror lc rgb '#E69F00' title 'force solves', \
  '' using 'steps':(place(column('scheme'))-0.18):(column('steps') < column('solves') ? sprintf('%g', column('steps')) : '') with labels left offset 0.5,0.1  notitle, \
  '' using 'solves':(place(column('scheme'))+0.18):(column('steps') < column('solves') ? sprintf('%g', column('solves')) : '') with labels left offset 0.5,-0.1  notitle, \
  '' using 'steps':(place(column('scheme'))):(column('steps') < column('solves') ? '' : sprintf('%g', column('steps'))) with labels left offset 0.5,0 notitle
