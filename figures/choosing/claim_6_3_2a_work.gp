# Error against work on three problems with closed forms: a curve for each technique over six steps.
tall = 1510
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955
# Rows of the table, in the order of the library; of the four timewarps one.
# Errors of rounding are shown at 1e-11.
array rows[14] = [0, 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16]
array names[14] = ['contact\_damped', 'basic', 'analytic', 'time\_stepping', 'impulse', 'damped', 'timewarp\_simple', 'glued', 'penalty', 'faure', 'relaxation', 'settling', 'optimised', 'microcollisions']
array problems[3] = ['a cube bounces three times', 'a box slides to a stop', 'a block rocks back']
set linetype 7 lc rgb '#999999' lw 2 dt (6,6) pt 4 ps 0.7
set linetype 9 lc rgb '#882255' lw 2 dt (2,4) pt 8 ps 0.8
set linetype 10 lc rgb '#117733' lw 2 dt (12,3) pt 12 ps 0.8
set linetype 11 lc rgb '#332288' lw 2 dt (3,6) pt 2 ps 0.8
set linetype 12 lc rgb '#999933' lw 2 dt (16,4,2,4) pt 1 ps 0.8
set linetype 13 lc rgb '#CC6677' lw 2 dt (2,8) pt 14 ps 0.8
set linetype 14 lc rgb '#CC3311' lw 2 dt (8,8) pt 10 ps 0.8
set logscale xy
set xrange [20:2e6]; set xtics 1,10; set format x powers
set yrange [1e-12:20]; set ytics 1e-12,1e3; set format y powers; unset mytics
side = 'largest error'; @SIDE
set key at screen 0.56,0.996 center top vertical maxrows 7 width 1 samplen 2
shown(e) = e > 1e-11 ? e : 1e-11
do for [p = 0:2] {
  top = 0.848 - 0.277*p
  set tmargin at screen top; set bmargin at screen top - 0.209
  set label 1 problems[p + 1] at graph 0.5,1.05 center textcolor rgb '#202020'
  set label 2 'one per cent' at graph 0.99,first 0.01 right offset 0,0.6 textcolor rgb soft
  set arrow 1 from graph 0,first 0.01 to graph 1,first 0.01 nohead lt 8 dt (2,4)
  if (p == 2) { set xlabel 'work: what the step reports count' offset 0,0.3 }
  plot for [k = 1:14] stem.'.csv' using (column('technique') == rows[k] && column('problem') == p ? column('work') : NaN):(shown(column('error'))) with linespoints lt k title p == 0 ? names[k] : ''
  unset key
}
