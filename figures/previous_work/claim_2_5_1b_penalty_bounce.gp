# Heights of a dropped cube on its default springs, and the speed from which a cube passes a plate.
tall = 860
@PAGE
set multiplot
set lmargin at screen 0.16; set rmargin at screen 0.95
bounce = stem.'_bounce.csv'
set key at screen 0.56,0.992 center top horizontal
set tmargin at screen 0.92; set bmargin at screen 0.6
set xrange [0.4:1.4]; set yrange [-0.16:0.5]
set xlabel 'time [s]' offset 0,0.4
side = 'height of the lower face [m]'; @SIDE
set arrow 1 from 0.4,0 to 1.4,0 nohead lt 8 lw 1
plot bounce using 'time_s':'e0' with lines lt 1 title 'restitution 0', \
  '' using 'time_s':'e5' with lines lt 2 title '0.5', \
  '' using 'time_s':'e9' with lines lt 3 title '0.9'
unset arrow 1
set key at screen 0.56,0.5 center top horizontal
set tmargin at screen 0.43; set bmargin at screen 0.09
set logscale xy
set xrange [0.008:0.6]; set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set yrange [10:100]; set ytics (10, 20, 50, 100)
set xlabel 'thickness of the plate [m]'
side = 'speed [m/s]'; @SIDE
plot stem.'.csv' using 'thickness_m':'speed_m_s' with linespoints lt 1 title 'a cube of 0.2 m passes', \
  '' using 'thickness_m':'law_m_s' with lines lt 8 title 'critical damping'
