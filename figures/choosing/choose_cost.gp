# Work of a step against the number of boxes: stacks that stand apart, and one pyramid.
tall = 1110
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955
array rows[14] = [0, 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16]
array names[14] = ['contact\_damped', 'basic', 'analytic', 'time\_stepping', 'impulse', 'damped', 'timewarp\_simple', 'glued', 'penalty', 'faure', 'relaxation', 'settling', 'optimised', 'microcollisions']
set linetype 7 lc rgb '#999999' lw 2 dt (6,6) pt 4 ps 0.7
set linetype 9 lc rgb '#882255' lw 2 dt (2,4) pt 8 ps 0.8
set linetype 10 lc rgb '#117733' lw 2 dt (12,3) pt 12 ps 0.8
set linetype 11 lc rgb '#332288' lw 2 dt (3,6) pt 2 ps 0.8
set linetype 12 lc rgb '#999933' lw 2 dt (16,4,2,4) pt 1 ps 0.8
set linetype 13 lc rgb '#CC6677' lw 2 dt (2,8) pt 14 ps 0.8
set linetype 14 lc rgb '#CC3311' lw 2 dt (8,8) pt 10 ps 0.8
set logscale xy
set xrange [8:1300]; set xtics (10, 100, 1000)
set yrange [8:1e6]; set ytics 1,10; set format y powers
side = 'work of a step'; @SIDE
set key at screen 0.56,0.992 center top vertical maxrows 7 width 1 samplen 2
array scenes[2] = ['stacks of five that stand apart', 'one pyramid']
do for [s = 0:1] {
  top = 0.812 - 0.4*s
  set tmargin at screen top; set bmargin at screen top - 0.32
  set label 1 scenes[s + 1] at graph 0.5,1.05 center textcolor rgb '#202020'
  if (s == 1) { set xlabel 'boxes' offset 0,0.3 }
  plot for [k = 1:14] stem.'.csv' using (column('technique') == rows[k] && column('scene') == s ? column('boxes') : NaN):'work' with linespoints lt k title s == 0 ? names[k] : ''
  unset key
}
