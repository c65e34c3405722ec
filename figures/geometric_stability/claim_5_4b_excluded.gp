# What Baraff's method and ours have to do with all boxes and without the stable ones, and how long
# the gain lasts in a run.
tall = 1400
@PAGE
mark = form eq 'svg' ? 0.75 : 1.2
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
stats stem.'.csv' using 'rows' name 'rows' nooutput
set label 90 'filled, dashed: all boxes; open: stable boxes left out' at screen 0.56,1 - 16.0/tall center textcolor rgb '#202020'
set logscale xy
set xrange [0.93*rows_min:1.07*rows_max]
set xtics (3, 5, 7, 9, 11, 13, 15, 17, 19, 21)
set mxtics 1
set format y powers
set key at graph 0.02,0.99 left top vertical maxcols 1 samplen 3

# A panel's place, from above.
top(row) = row < 3 ? 45.0 + 318*row : 1042.0  # a label is below the third and the fourth
PANEL = "set tmargin at screen 1 - top(row)/tall; set bmargin at screen 1 - (top(row) + 262)/tall"
row = 0
@PANEL
side = 'count'; @SIDE
plot stem.'.csv' using 'rows':'pivots_all' with linespoints lt 2 ps mark title 'pivots, Baraff', \
  '' using 'rows':'unknowns_all' with linespoints lt 1 dt (12,4) ps mark title 'unknowns', \
  '' using 'rows':'pivots_left' with linespoints lt 2 dt 1 pt 4 ps mark notitle, \
  '' using 'rows':'unknowns_left' with linespoints lt 1 pt 6 ps mark notitle
unset label 90

row = 1
@PANEL
side = 'multiplications'; @SIDE
set yrange [*:1e11]
plot stem.'.csv' using 'rows':'baraff_all' with linespoints lt 2 ps mark title 'Baraff', \
  '' using (column('gave_up_all') == 1 ? column('rows') : NaN):'baraff_all' with points pt 6 ps 2.5*mark lw 2 lc rgb '#202020' title 'pivoting gave up', \
  '' using (column('gave_up_left') == 1 ? column('rows') : NaN):'baraff_left' with points pt 6 ps 2.5*mark lw 2 lc rgb '#202020' notitle, \
  '' using 'rows':'ours_all' with linespoints lt 3 dt (12,4) ps mark title 'our default solver', \
  '' using 'rows':'baraff_left' with linespoints lt 2 dt 1 pt 4 ps mark notitle, \
  '' using 'rows':'ours_left' with linespoints lt 3 dt 1 pt 8 ps mark notitle

row = 2
@PANEL
set xlabel 'rows of the pyramid' offset 0,0.4
set format y '%g'
set yrange [1:120]
set ytics (1, 2, 4, 10, 20, 40, 100)
side = 'all over left'; @SIDE
set object 1 rectangle from graph 0,first 4 to graph 1,first 120 fc rgb '#d9efe6' fs solid 1.0 noborder behind
set object 2 rectangle from graph 0,first 1 to graph 1,first 1.5 fc rgb '#f7e6da' fs solid 1.0 noborder behind
set label 1 'much faster' at graph 0.98,first 90 right textcolor rgb soft
set label 2 'hardly any gain' at graph 0.98,first 1.2 right textcolor rgb soft
plot stem.'.csv' using 'rows':'baraff_saved' with linespoints lt 2 ps mark title 'multiplications, Baraff', \
  '' using 'rows':'ours_saved' with linespoints lt 3 ps mark title 'multiplications, ours', \
  '' using 'rows':((column('unknowns_all')/column('unknowns_left'))**3) with linespoints lt 8 dt (3,3) pt 2 ps mark title 'cube of the unknowns', \
  '' using 'rows':(column('unknowns_all')/column('unknowns_left')) with linespoints lt 1 ps mark title 'unknowns'
unset object; unset label 1; unset label 2

row = 3
@PANEL
unset logscale
set xrange [0:*]
set yrange [0.9:2.6]
set xtics auto
set ytics 0.5
set xlabel 'time [s]' offset 0,0.4
side = 'unknowns, all over left'; @SIDE
set key at graph 0.99,0.99 right top
plot stem.'_run.csv' using 'time_s':'rests' with lines lt 1 title 'at rest, 11 rows', \
  '' using 'time_s':'knocked' with lines lt 2 title 'five rows, light boxes knocked', \
  '' using 'time_s':'falls' with lines lt 3 title 'three rows, which fall'
