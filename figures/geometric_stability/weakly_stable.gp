# Balance with friction: the least friction of a leaning plank, and a box between two walls.
tall = 860
@PAGE
set multiplot
m = form eq 'svg' ? 0.75 : 1  # of marks: terminals differ
set lmargin at screen 0.17; set rmargin at screen 0.955
set tmargin at screen 0.965; set bmargin at screen 0.60
set xrange [2:*]; set xtics 4
set logscale y; set format y powers
set yrange [1e-10:10]; set ytics 1e-10,100
set xlabel 'edges of the pyramid of friction' offset 0,0.3
side = 'relative error'; @SIDE
set key at graph 0.99,0.62 right top vertical maxcols 1 samplen 3
plot stem.'.csv' using 'edges':'by_hand' with lines lt 8 title 'what the pyramid lacks', \
  '' using 'edges':'between' with points lt 2 ps m title 'plank between two edges', \
  '' using 'edges':'along' with points lt 1 ps m title 'plank along an edge'

unset logscale y; set format y '%g'
set tmargin at screen 0.475; set bmargin at screen 0.115
set xrange [0:*]; set xtics 0.1
set yrange [*:0.08]; set ytics autofreq
set xlabel 'time [s]'
side = 'height [m]'; @SIDE
set key at graph 0.02,0.05 left bottom vertical maxcols 1 samplen 3
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lt 8 dt (6,4)
set label 1 'balance allows this as well' at graph 0.98,first 0 right offset 0,-0.9 textcolor rgb soft
plot stem.'_falls.csv' using 'time_s':(-column('free_m')) with lines lt 8 lw 5 lc rgb '#c2cad1' title 'free fall', \
  '' using 'time_s':(-column('contact_damped_m')) with points lt 1 ps 0.7*m title 'contact\_damped', \
  '' using 'time_s':(-column('analytic_m')) with points lt 2 pt 4 ps m title 'analytic'
