# Figures 6.1 to 6.3 under techniques without the option pose: gap by technique, on a log axis.
tall = 735
@PAGE
array names[12] = ['damped', 'timewarp\_simple', 'timewarp\_safer', 'timewarp\_swept', 'timewarp\_full', 'basic', 'penalty', 'faure', 'relaxation', 'settling', 'optimised', 'microcollisions']
set lmargin at screen 0.33; set rmargin at screen 0.95
set tmargin at screen 0.9; set bmargin at screen 0.13
set logscale x
set xrange [3e-5:2]; set xtics 1e-5,10; set format x powers; unset mxtics
set xlabel 'largest opening or overlap [m]' offset 0,0.3
set yrange [11.5:-0.5]
set border 1 lc rgb '#808080'; unset grid; set grid x
set ytics scale 0 ('' -5)
set for [k=1:12] ytics add (names[k] k - 1)
set key at screen 0.6,0.985 center top vertical maxrows 1 samplen 1
set label 1 'stands still' at 6e-5,-0.22 left textcolor rgb soft
shown(g) = g > 4e-5 ? g : 4e-5
plot stem.'.csv' using (shown(column('fig6_1_gap_m'))):($1-0.22) with points lt 1 ps 1.5 title 'figure 6.1', \
  '' using (shown(column('fig6_2_gap_m'))):'technique' with points lt 2 ps 1.5 title 'figure 6.2', \
  '' using (shown(column('fig6_3_gap_m'))):($1+0.22) with points lt 3 ps 1.7 title 'figure 6.3'
