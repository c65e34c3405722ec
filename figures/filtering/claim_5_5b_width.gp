# Amplitude, squirm, sharpness and overlap against the width of the box filter.
tall = 1400
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
impact = stem.'_impact.csv'
set xrange [0.4:15.6]; set xtics 1,2
set key at screen 0.56,0.992 center top horizontal

set tmargin at screen 0.945; set bmargin at screen 0.74
set yrange [0:1.08]; set ytics 0,0.25
side = 'over that computed'; @SIDE
plot stem.'.csv' using 'frames':'amplitude' with linespoints lt 1 title 'amplitude', \
  '' using 'frames':'amplitude':'amplitude_low':'amplitude_high' with yerrorbars lt 1 dt 1 notitle, \
  '' using 'frames':'squirm' with linespoints lt 2 title 'squirm', \
  '' using 'frames':'squirm':'squirm_low':'squirm_high' with yerrorbars lt 2 dt 1 notitle, \
  '' using 'frames':'white' with lines lt 8 dt (3,3) title 'squirm of white noise'
unset key

set tmargin at screen 0.695; set bmargin at screen 0.535
side = 'sharpness'; @SIDE
set label 1 "largest change of a landing cube's speed,\nover that computed" at graph 0.98,0.9 right textcolor rgb soft
plot stem.'.csv' using 'frames':'sharpness' with linespoints lt 3

set tmargin at screen 0.49; set bmargin at screen 0.33
set label 1 'most added in a frame' at 2.6,3.3 left textcolor lt 1
set label 2 'deepest in the run' at 9.3,-2.7 left textcolor lt 4
set xlabel 'frames averaged' offset 0,0.3
set yrange [-3.4:4.6]; set ytics -2,2
side = 'overlap added [cm]'; @SIDE
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lc rgb '#404040' lw 1
plot stem.'.csv' using 'frames':(100*column('overlap_m')) with linespoints lt 4, \
  '' using 'frames':(100*column('added_m')) with linespoints lt 1, \
  '' using 'frames':(100*column('added_m')):(100*column('added_m_low')):(100*column('added_m_high')) with yerrorbars lt 1 dt 1, \
  '' using 'frames':(100*column('overlap_m')):(100*column('overlap_m_low')):(100*column('overlap_m_high')) with yerrorbars lt 4 dt 1
unset arrow 1; unset label 1; unset label 2

set tmargin at screen 0.235; set bmargin at screen 0.065
set xrange [0.25:0.65]; set xtics 0,0.1
set yrange [-0.02:0.72]; set ytics 0,0.2
set xlabel 'time since a cube was let go at 1 m [s]' offset 0,0.3
side = 'height [m]'; @SIDE
set key at graph 0.98,graph 0.98 right top vertical maxcols 1
plot impact using 'time_s':'height_1_m' with linespoints lt 8 title 'computed', \
  '' using 'time_s':'height_5_m' with linespoints lt 1 title '5 frames', \
  '' using 'time_s':'height_15_m' with linespoints lt 2 title '15 frames'
