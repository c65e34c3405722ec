# Figure 6.3's boxes under techniques with the option pose: gap by technique, on a log axis.
tall = 600
@PAGE
array names[6] = ['contact\_damped', 'analytic', 'time\_stepping', 'impulse', 'impulse, 100 passes', 'glued, impulses']
set lmargin at screen 0.33; set rmargin at screen 0.95
set tmargin at screen 0.87; set bmargin at screen 0.14
set logscale x
set xrange [1e-16:2e-2]; set xtics 1e-15,1e3; set format x powers; unset mxtics
set xlabel 'largest opening or overlap [m]' offset 0,0.3
set yrange [5.5:-0.5]
set border 1 lc rgb '#808080'; unset grid; set grid x
set ytics scale 0 ('' -5)
set for [k=1:6] ytics add (names[k] k - 1)
set key at screen 0.6,0.985 center top vertical maxrows 2 samplen 1
shown(g) = g > 2e-16 ? g : 2e-16
plot stem.'.csv' using (shown(column('exponential_gap_m'))):'technique':(shown(column('exponential_gap_m'))):'separate_gap_m':'technique':'technique' with boxxyerror lc rgb '#b0b0b0' notitle, \
  '' using 'separate_gap_m':'technique' with points pt 6 ps 2 lw 2 lc rgb '#D55E00' title 'pose=separate', \
  '' using (shown(column('exponential_gap_m'))):'technique' with points pt 7 ps 1.7 lc rgb '#0072B2' title 'pose=exponential'
