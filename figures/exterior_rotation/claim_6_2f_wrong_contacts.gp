# Changes of contact of the falling column, by scheme and time; how many are wrong; and the tolerance.
tall = 1530
@PAGE
set multiplot
height(points) = 1 - points*1.0/tall
changes = stem.'_changes.csv'
sweep = stem.'_sweep.csv'
m = form eq 'svg' ? 0.7 : 0.95
set lmargin at screen 0.29; set rmargin at screen 0.955
array names[9] = ['forward Euler', 'semi-implicit', 'impulse', 'midpoint', 'rk4', 'forward Euler', 'semi-implicit', 'impulse', 'leapfrog']

# One by one.
set tmargin at screen height(96); set bmargin at screen height(570)
set xrange [0:1.01]; set xtics 0,0.2
set yrange [9.7:0.3]; unset ytics; unset grid
do for [k=1:9] { set label k names[k] at graph -0.02,first k right textcolor rgb '#202020' }
set label 20 'exponential' at screen 0.022,first 7.5 center rotate textcolor rgb soft
set arrow 20 from graph -0.42,first 5.5 to graph 1,first 5.5 nohead lc rgb '#808080' lw 1
set key at screen 0.54,height(6) center top vertical maxrows 3 samplen 1.5 width -3
set xlabel 'time [s]' offset 0,0.3
row(k, w) = column('scheme') > 0 && column('kind') == k && column('wrong') == w ? column('scheme') + (column('joint') - 1.5)*0.17 : NaN
plot changes using (column('scheme') == 0 ? column('time_s') : NaN):(9.7):(0):(-9.4) with vectors nohead lc rgb '#9a9a9a' lw 1.5 dt (6,4) title 'the right motion', \
  '' using 'time_s':(row(0, 1)) with points pt 11 ps m lc rgb '#D55E00' title 'wrong: lost', \
  '' using 'time_s':(row(1, 1)) with points pt 7 ps 0.85*m lc rgb '#0072B2' title 'wrong: found', \
  '' using 'time_s':(row(2, 1)) with points pt 5 ps 0.8*m lc rgb '#303030' title 'wrong: overlap', \
  '' using 'time_s':(row(3, 1)) with points pt 13 ps m lc rgb '#E69F00' title 'wrong: cleared', \
  '' using 'time_s':(row(0, 0)) with points pt 10 ps m lw 1.5 lc rgb '#009E73' title 'as it should', \
  '' using 'time_s':(row(1, 0)) with points pt 6 ps 0.85*m lw 1.5 lc rgb '#009E73' notitle
unset key; unset label; unset arrow
@AXES

# How many.
set ytics nomirror; unset grid
set tmargin at screen height(696); set bmargin at screen height(1026)
set xrange [0:*]; set xtics nomirror 0,10; set grid x lc rgb '#dddddd' lw 0.7 dt 1
set yrange [9.7:0.3]; unset ytics
do for [k=1:9] { set label k names[k] at graph -0.02,first k right textcolor rgb '#202020' }
set label 20 'exponential' at screen 0.022,first 7.5 center rotate textcolor rgb soft
set arrow 20 from graph -0.42,first 5.5 to graph 1,first 5.5 nohead lc rgb '#808080' lw 1
set style fill solid 0.85 noborder
set xlabel 'changes of contact' offset 0,0.3
set key at screen 0.54,height(662) center top horizontal maxcols 2 samplen 1.5 width 1
plot stem.'.csv' using (0.5*column('wrong')):(column('scheme') - 0.17):(0.5*column('wrong')):(0.16) with boxxy lc rgb '#D55E00' title 'wrong', \
  '' using (0.5*column('missed')):(column('scheme') + 0.19):(0.5*column('missed')):(0.16) with boxxy lc rgb '#56B4E9' title 'missed', \
  '' using (column('wrong') + 0.5):(column('scheme') - 0.17):(sprintf('%d', column('wrong'))) with labels left font ',11' notitle, \
  '' using (column('missed') + 0.5):(column('scheme') + 0.22):(sprintf('%d', column('missed'))) with labels left font ',11' notitle
unset key; unset label; unset arrow
@AXES

# Tolerances.
set lmargin at screen 0.17
set tmargin at screen height(1208); set bmargin at screen height(1438)
set logscale x; set mxtics 1; set xrange [1e-9:0.1]; set xtics nomirror 1e-9,1e2; set format x powers
set yrange [-1:*]; set ytics nomirror 0,10
set grid y
side = 'wrong changes'; @SIDE
set xlabel 'distance that counts as touching, over an edge' offset 0,0.3
set key at screen 0.54,height(1118) center top vertical maxrows 3 samplen 2 width -3
plot sweep using 'tolerance':'wrong_1' with linespoints lt 5 title 'forward Euler', \
  '' using 'tolerance':'wrong_2' with linespoints lt 3 title 'semi-implicit', \
  '' using 'tolerance':'wrong_4' with linespoints lt 2 title 'midpoint', \
  '' using 'tolerance':'wrong_5' with linespoints lt 1 title 'rk4', \
  '' using 'tolerance':'wrong_7' with linespoints lt 4 title 'same, exponential'
