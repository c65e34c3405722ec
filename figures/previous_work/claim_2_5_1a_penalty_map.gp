# Which runs are right, over stiffness and steps a second, for three scenes.
tall = 1220
@PAGE
set multiplot
set lmargin at screen 0.16; set rmargin at screen 0.95
numbers = stem.'.csv'
scenes = 'one ten loaded'
titles = '"one cube" "ten cubes in a stack" "a hundred times the mass on a cube"'
set logscale xy
set xrange [45:5200]; set xtics (60, 120, 240, 480, 960, 1920, 3840)
set yrange [60:1.7e6]; set ytics 10,10; set format y powers
set key at screen 0.56,0.994 center top horizontal maxcols 2 width -1
do for [panel = 1:3] {
  set tmargin at screen 1.2 - 0.295*panel; set bmargin at screen 1.2 - 0.295*panel - 0.225
  if (panel == 3) { set xlabel 'steps a second' }
  side = 'stiffness [N/m]'; @SIDE
  set label 1 word(titles, panel) at graph 0.5,1.06 center textcolor rgb '#202020'
  here = word(scenes, panel)
  plot numbers using 'rate_1_s':(column(here) == 0 ? column('stiffness_N_m') : 1/0) with points lt 1 ps 1.6 title (panel == 1 ? 'stands and rests' : ''), \
    '' using 'rate_1_s':(column(here) == 1 ? column('stiffness_N_m') : 1/0) with points lt 5 pt 10 ps 1.2 title (panel == 1 ? 'sinks in' : ''), \
    '' using 'rate_1_s':(column(here) == 2 ? column('stiffness_N_m') : 1/0) with points lt 4 pt 6 ps 1.2 title (panel == 1 ? 'does not rest' : ''), \
    '' using 'rate_1_s':(column(here) == 3 ? column('stiffness_N_m') : 1/0) with points lt 2 pt 2 ps 1.2 title (panel == 1 ? 'gains energy' : ''), \
    (0.41421356*2*x)**2 with lines lt 8 notitle
  unset key
}
