# One box falls over an edge: two moments with the pivot magnified, its gap over time, gaps of single steps.
tall = 880
@PAGE
set multiplot
height(points) = 1 - points*1.0/tall
across(points) = points*1.0/wide
load stem.'_layout.gp'
table = stem.'.csv'
do for [k=1:2] {
  left = 4 + (frame_wide + 4)*(k - 1)
  foot = 8 + frame_tall
  set lmargin at screen across(left); set rmargin at screen across(left + frame_wide)
  set bmargin at screen height(foot); set tmargin at screen height(foot - frame_tall)
  set autoscale
  stats stem.'_frames.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.2f s', shown_max) at screen across(left + 42),height(foot - 18) center front textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
  set lmargin at screen across(left + inset_left); set rmargin at screen across(left + inset_left + inset_edge)
  set bmargin at screen height(foot - inset_foot); set tmargin at screen height(foot - inset_foot - inset_edge)
  load stem.'_inset'.k.'.gp'
}
low = 14 + frame_tall

# What the lines mean.
set lmargin at screen 0.02; set rmargin at screen 0.98
set tmargin at screen height(low); set bmargin at screen height(low + 66)
set xrange [0:1]; set yrange [0:1]
set key inside center center vertical maxrows 2 maxcols 2 samplen 1.5 width -1
mark = form eq 'svg' ? 0.9 : 1.3
plot NaN with lines dt (6,4) lw 1.2 lc rgb '#303030' title 'exact', \
  NaN with points pt 6 ps 1.3*mark lw 1.2 lc rgb '#303030' title sprintf('inset: %g times', magnification), \
  NaN with points pt 7 ps mark lc rgb '#D55E00' title 'pivot', \
  NaN with lines dt 1 lw 1.5 lc rgb '#D55E00' title "circle for centre"
unset key

@AXES
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:*] noextend; set xtics nomirror 0,0.1; set ytics nomirror
low = low + 116
set tmargin at screen height(low); set bmargin at screen height(low + 125)
set key at screen 0.56,height(low - 52) center top horizontal maxrows 2 maxcols 2 samplen 2.5 width -1
set format x ''
set yrange [*:*]; set ytics nomirror 0,1
side = 'gap [mm]'; @SIDE
plot table using 'time_s':'forward_euler_mm' with lines lt 1 title 'forward Euler', \
  '' using 'time_s':'semi_implicit_mm' with lines lt 2 title 'semi-implicit', \
  '' using 'time_s':'impulse_mm' with lines lt 3 title 'impulses', \
  '' using 'time_s':'midpoint_mm' with lines lt 4 title 'midpoint'
unset key

low = low + 140
set tmargin at screen height(low); set bmargin at screen height(low + 135)
set logscale y; set format y powers; set yrange [1e-16:10]; set ytics nomirror 1e-15,1e6; unset mytics
side = 'corner error [m]'; @SIDE
set label 2 'forward Euler' at graph 0.3,first 0.3 center textcolor rgb '#0072B2'
set label 3 'midpoint' at graph 0.98,first 2e-6 right textcolor rgb '#A0507F'
set label 4 'rk4' at graph 0.6,first 3e-11 center textcolor rgb '#9A6F00'
set label 5 'reference' at graph 0.98,first 1.2e-12 offset 0,-0.1 right textcolor rgb soft
plot table using 'time_s':'forward_euler_apart_m' with lines lt 1, \
  '' using 'time_s':'midpoint_apart_m' with lines lt 4, \
  '' using 'time_s':'rk4_apart_m' with lines lt 5, \
  '' using 'time_s':'reference_apart_m' with lines lt 8
unset logscale y; unset label

low = low + 150
set tmargin at screen height(low); set bmargin at screen height(low + 125)
set format x '%g'; set format y '%g'; set yrange [*:*]; set ytics nomirror -0.4,0.2
set xlabel 'time [s]' offset 0,0.3
side = 'per step [mm]'; @SIDE
steps = stem.'_steps.csv'
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lc rgb '#404040' lw 1
set label 2 'gap' at graph 0.03,first 0.13 left textcolor rgb soft
set label 3 'overlap' at graph 0.03,first -0.13 left textcolor rgb soft
set label 4 'grey: ± ω² h² s / 2' at graph 0.2,graph 0.88 left textcolor rgb soft
plot steps using 'time_s':'arc_mm' with lines lt 8 lw 5 lc rgb '#BBBBBB' notitle, \
  '' using 'time_s':(-column('arc_mm')) with lines lt 8 lw 5 lc rgb '#BBBBBB' notitle, \
  '' using 'time_s':'forward_euler_mm' with lines lt 1 notitle, \
  '' using 'time_s':'semi_implicit_mm' with lines lt 2 notitle, \
  '' using 'time_s':'impulse_mm' with lines lt 3 notitle, \
  '' using 'time_s':'midpoint_mm' with lines lt 4 notitle
