# The shot at the pyramid over time: energy, overlap, chatter.
tall = 980
@PAGE
set multiplot
path = stem.'.csv'
set lmargin at screen 0.18; set rmargin at screen 0.955
stats path using 'time_s' name 'time' nooutput
set xrange [time_min:time_max]
set arrow 1 from 0,graph 0 to 0,graph 1 nohead lt 8 dt (6,4)
set format x ''
set key at graph 0.985,0.97 right top vertical maxcols 1 samplen 3

set tmargin at screen 0.975; set bmargin at screen 0.70
set yrange [*:*]
side = 'energy [J]'; @SIDE
set label 1 'the shot' at 0.06,graph 0.08 left textcolor rgb soft
plot path using 'time_s':'total_J' with lines lt 1 title 'kinetic and potential', \
  '' using 'time_s':'kinetic_J' with lines lt 2 title 'kinetic'
unset label 1; unset key

set tmargin at screen 0.665; set bmargin at screen 0.43
set yrange [0:*]
side = 'overlap [mm]'; @SIDE
plot path using 'time_s':'overlap_mm' with lines lt 1

set tmargin at screen 0.395; set bmargin at screen 0.135
set format x '%g'
set xlabel 'time since the shot [s]'
side = 'chatter [mm]'; @SIDE
plot path using 'time_s':'chatter_mm' with lines lt 1
