# A box turns on a box that turns: two moments with the moving edge magnified, and how far both edges come apart.
tall = 890
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
set tmargin at screen height(low); set bmargin at screen height(low + 90)
set xrange [0:1]; set yrange [0:1]
set key inside center center vertical maxrows 3 maxcols 2 samplen 1.5 width -1
mark = form eq 'svg' ? 0.9 : 1.3
plot NaN with lines dt (6,4) lw 1.2 lc rgb '#303030' title 'exact', \
  NaN with points pt 6 ps 1.3*mark lw 1.2 lc rgb '#303030' title sprintf('inset: %g times', magnification), \
  NaN with points pt 7 ps mark lc rgb '#D55E00' title 'pivots', \
  NaN with lines dt 1 lw 1.5 lc rgb '#D55E00' title 'circles for centres', \
  NaN with lines dt (6,4) lw 1.5 lc rgb '#D55E00' title 'circle for the pivot'
unset key

@AXES
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:*] noextend; set xtics nomirror 0,0.1; set ytics nomirror

low = low + 138
set tmargin at screen height(low); set bmargin at screen height(low + 92)
set key at screen 0.56,height(low - 54) center top vertical maxrows 2 maxcols 2 samplen 2.5 width -1
set format x ''
set autoscale y
stats table using (1e3*column('semi_implicit_exp_upper_m')) every ::1 name 'most' nooutput
set yrange [0:1.07*most_max]; set ytics nomirror 0,20
side = 'gap [mm]'; @SIDE
set label 1 'lower edge; position and rotation stepped separately' at graph 0.03,graph 0.88 left textcolor rgb soft
mm(name) = 1e3*column(name)
plot table using 'time_s':(mm('forward_euler_lower_m')) with lines lt 1 title 'forward Euler', \
  '' using 'time_s':(mm('semi_implicit_lower_m')) with lines lt 2 title 'semi-implicit', \
  '' using 'time_s':(mm('impulse_lower_m')) with lines lt 3 title 'impulses', \
  '' using 'time_s':(mm('midpoint_lower_m')) with lines lt 4 title 'midpoint'
unset key

low = low + 106
set tmargin at screen height(low); set bmargin at screen height(low + 92)
set label 1 'upper edge, the same'
plot table using 'time_s':(mm('forward_euler_upper_m')) with lines lt 1, \
  '' using 'time_s':(mm('semi_implicit_upper_m')) with lines lt 2, \
  '' using 'time_s':(mm('impulse_upper_m')) with lines lt 3, \
  '' using 'time_s':(mm('midpoint_upper_m')) with lines lt 4

low = low + 106
set tmargin at screen height(low); set bmargin at screen height(low + 92)
set label 1 'upper edge; SE(3) exponential'
set label 2 'lower edge' at graph 0.98,first 12 right textcolor rgb soft
plot table using 'time_s':(mm('forward_euler_exp_upper_m')) with lines lt 1, \
  '' using 'time_s':(mm('semi_implicit_exp_upper_m')) with lines lt 2, \
  '' using 'time_s':(mm('impulse_exp_upper_m')) with lines lt 3, \
  '' using 'time_s':(mm('forward_euler_exp_lower_m')) with lines lt 8 lw 3
unset label

low = low + 106
set tmargin at screen height(low); set bmargin at screen height(low + 98)
set format x '%g'
set xlabel 'time [s]' offset 0,0.3
set logscale y; set format y powers; set yrange [1e-16:10]; set ytics nomirror 1e-15,1e5,1e-5; unset mytics
side = 'gap [m]'; @SIDE
set label 1 'upper edge' at graph 0.03,first 3e-2 left textcolor rgb soft
set label 2 'leapfrog, with both' at graph 0.98,first 3e-2 right textcolor rgb '#2E7D9A'
set label 4 'rk4' at graph 0.6,first 2e-10 center textcolor rgb '#9A6F00'
set label 5 'reference' at graph 0.98,first 6e-12 right textcolor rgb soft
plot table using 'time_s':'leapfrog_upper_m' with lines lt 6 lw 3, \
  '' using 'time_s':'leapfrog_exp_upper_m' with lines lt 8 dt (3,3) lc rgb '#2E7D9A', \
  '' using 'time_s':'rk4_upper_m' with lines lt 5, \
  '' using 'time_s':'reference_upper_m' with lines lt 8
