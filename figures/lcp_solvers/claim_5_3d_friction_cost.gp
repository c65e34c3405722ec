# Work of a pivot, unknowns and entries, with friction and without.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.93
set logscale xy; set format y powers; set xrange [7:72]
set xtics (8, 16, 24, 32, 48, 64)
set tmargin at screen 0.85; set bmargin at screen 0.52
side = 'multiplications of a pivot'; @SIDE
set key at screen 0.55,0.985 center top vertical maxcols 1
plot stem.'.csv' using 'contacts':'friction' with linespoints lt 2 title 'friction, new factors', \
  '' using 'contacts':'new_factors' with linespoints lt 3 title 'no friction, new factors', \
  '' using 'contacts':'updated' with linespoints lt 1 title 'no friction, updated factors'
unset key
set tmargin at screen 0.44; set bmargin at screen 0.135
set xlabel 'contacts'
side = 'unknowns, entries'; @SIDE
set label 1 'marks: entries of the matrix' at graph 0.03,0.93 textcolor rgb soft
set label 2 'lines: unknowns' at graph 0.03,0.85 textcolor rgb soft
plot stem.'.csv' using 'contacts':'unknowns_friction' with lines lt 2, '' using 'contacts':'unknowns' with lines lt 1, \
  '' using 'contacts':'entries_friction' with points lt 2, '' using 'contacts':'entries' with points lt 1
unset multiplot
