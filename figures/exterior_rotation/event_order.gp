# Errors across openings of joints against the step, of the first opening's moment, and under error control.
tall = 1500
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
height(points) = 1 - points*1.0/tall
m = form eq 'svg' ? 0.75 : 1.0  # of marks: terminals differ
adaptive = stem.'_adaptive.csv'
moment = stem.'_moment.csv'
now(e, name) = column('end') == e && column(name) > 0 ? column(name) : NaN
set logscale xy; set mxtics 1; set mytics 1
set format x ''; set format y powers
set xrange [1e-3:0.06]; set xtics (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
set yrange [1e-13:1]; set ytics 1e-12,1e3
set key at screen 0.54,height(6) center top horizontal maxcols 2 samplen 2 width -2

side = 'error after one opening [m]'; @SIDE
set tmargin at screen height(84); set bmargin at screen height(374)
plot stem.'.csv' using 'step_s':(now(1,'semi_implicit_located_m')) with linespoints lt 3 pt 9 ps m title 'semi-implicit', \
  '' using 'step_s':(now(1,'semi_implicit_step_end_m')) with points lt 3 pt 8 ps m notitle, \
  '' using 'step_s':(now(1,'midpoint_located_m')) with linespoints lt 2 pt 5 ps m title 'midpoint', \
  '' using 'step_s':(now(1,'midpoint_step_end_m')) with points lt 2 pt 4 ps m notitle, \
  '' using 'step_s':(now(1,'rk4_located_m')) with linespoints lt 1 pt 7 ps m title 'rk4', \
  '' using 'step_s':(now(1,'rk4_step_end_m')) with points lt 1 pt 6 ps m notitle, \
  NaN with points lt 8 pt 6 ps m title 'noticed late'
unset key

side = 'after six changes [m]'; @SIDE
set tmargin at screen height(410); set bmargin at screen height(690)
plot stem.'.csv' using 'step_s':(now(2,'semi_implicit_located_m')) with linespoints lt 3 pt 9 ps m, \
  '' using 'step_s':(now(2,'semi_implicit_step_end_m')) with points lt 3 pt 8 ps m, \
  '' using 'step_s':(now(2,'midpoint_located_m')) with linespoints lt 2 pt 5 ps m, \
  '' using 'step_s':(now(2,'midpoint_step_end_m')) with points lt 2 pt 4 ps m, \
  '' using 'step_s':(now(2,'rk4_located_m')) with linespoints lt 1 pt 7 ps m, \
  '' using 'step_s':(now(2,'rk4_step_end_m')) with points lt 1 pt 6 ps m

side = 'moment of opening [s]'; @SIDE
set tmargin at screen height(722); set bmargin at screen height(1002)
set format x '%g'
set xlabel 'step [s]' offset 0,0.3
off(name) = column(name) > 0 ? column(name) : NaN
plot moment using 'step_s':(off('semi_implicit_located_s')) with linespoints lt 3 pt 9 ps m, \
  '' using 'step_s':(off('semi_implicit_step_end_s')) with points lt 3 pt 8 ps m, \
  '' using 'step_s':(off('midpoint_located_s')) with linespoints lt 2 pt 5 ps m, \
  '' using 'step_s':(off('midpoint_step_end_s')) with points lt 2 pt 4 ps m, \
  '' using 'step_s':(off('rk4_located_s')) with linespoints lt 1 pt 7 ps m, \
  '' using 'step_s':(off('rk4_step_end_s')) with points lt 1 pt 6 ps m

side = 'error after one opening [m]'; @SIDE
set tmargin at screen height(1140); set bmargin at screen height(1400)
set xrange [1e-4:1e-12]; set xtics (1e-4, 1e-6, 1e-8, 1e-10, 1e-12); set format x powers
set xlabel 'accuracy asked of the error-controlled method' offset 0,0.3
set key at screen 0.54,height(1092) center top horizontal maxcols 2 samplen 2 width -4
plot adaptive using 'accuracy':'located_m' with linespoints lt 1 pt 7 ps m title 'located', \
  '' using 'accuracy':'step_end_m' with linespoints lt 4 dt (3,3) pt 12 ps m title 'noticed late'
