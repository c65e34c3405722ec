# Energy of a clump that settles without velocities and of one that falls; height of a thrown box beside its parabola.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.16; set rmargin at screen 0.95
set key at screen 0.56,0.992 center top horizontal
set tmargin at screen 0.92; set bmargin at screen 0.6
set xrange [0:240]; set yrange [0:*]
set xlabel 'steps' offset 0,0.4
side = 'energy of eight cubes [J]'; @SIDE
plot stem.'.csv' using 'step':'settling' with lines lt 1 title 'settling', \
  '' using 'step':'default' with lines lt 2 title 'contact\_damped'
set key at screen 0.56,0.5 center top horizontal
set tmargin at screen 0.43; set bmargin at screen 0.11
set xrange [0:0.8]; set yrange [0:2.6]
set xlabel 'time [s]' offset 0,0.4
side = 'height of a thrown box [m]'; @SIDE
thrown = stem.'_thrown.csv'
plot thrown using 'time_s':'settling' with lines lt 1 title 'settling', \
  '' using 'time_s':'parabola' with lines lt 8 title 'free flight'
