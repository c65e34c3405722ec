# Five bodies in one world: bounce, sticky collision, slide, rest, topple.
tall = 860
@PAGE
set multiplot
path = stem.'.csv'
set lmargin at screen 0.18; set rmargin at screen 0.95
stats path using 'time_s' name 'time' nooutput
set xrange [0:time_max]
unset key
set format x ''

set tmargin at screen 0.975; set bmargin at screen 0.765
side = 'height [m]'; @SIDE
set label 1 'a cube bounces, and then sticks' at graph 0.97,0.85 right textcolor rgb soft
plot path using 'time_s':'bouncer_m' with lines lt 1

set tmargin at screen 0.735; set bmargin at screen 0.525
side = 'distance [m]'; @SIDE
set label 1 'a cube slides to a stop'
set arrow 1 from graph 0,first 1.529051988 to graph 1,first 1.529051988 nohead lt 8 dt (6,4)
set label 2 'closed form' at graph 0.97,first 1.529 right offset 0,-0.7 textcolor rgb soft
set label 1 at graph 0.97,0.45
set yrange [0:1.8]; set ytics 0,0.5
plot path using 'time_s':'slider_m' with lines lt 1
unset arrow 1; unset label 2; set ytics autofreq
set autoscale y

set tmargin at screen 0.495; set bmargin at screen 0.285
side = 'tilt [°]'; @SIDE
set label 1 'a post that leans too far falls over' at graph 0.97,0.45
set yrange [0:100]; set ytics 0,30
plot path using 'time_s':'post_deg' with lines lt 1

set tmargin at screen 0.255; set bmargin at screen 0.1
set format y '%g'; set format x '%g'
set xlabel 'time [s]' offset 0,0.3
set yrange [0:*]; set ytics 0,20
side = 'energy [J]'; @SIDE
set label 1 'all of them, and a stack of three that rests' at graph 0.97,0.35
plot path using 'time_s':'energy_J' with lines lt 1
