# Gaps of the falling column over time, and the error of its angle: centre and orientation apart, or one twist.
tall = 940
@PAGE
set multiplot
set lmargin at screen 0.175; set rmargin at screen 0.955

set key at screen 0.56,0.99 center top vertical maxrows 2 width -4
set tmargin at screen 0.915; set bmargin at screen 0.52
set logscale y; set format y powers; unset mytics
set yrange [1e-17:1]; set ytics 1e-16,1e3
set xrange [0:*]; set xtics 0,0.2
set xlabel 'time [s]' offset 0,0.3
side = 'largest gap or overlap [m]'; @SIDE
set arrow 1 from graph 0,first 1e-9 to graph 1,first 1e-9 nohead lt 8 dt (6,4)
set label 1 'refutes below 10^{-9}, confirms above 10^{-3}' at graph 0.98,first 1e-8 right textcolor rgb soft
set arrow 2 from graph 0,first 1e-3 to graph 1,first 1e-3 nohead lt 8 dt (6,4)
set label 2 'one unit in the last digit' at graph 0.98,first 1.2e-16 right textcolor rgb soft
plot stem.'.csv' using 'time_s':'rounding_m' with lines lt 8 lw 3 lc rgb '#b0b0b0' notitle, \
  '' using 'time_s':'separate_m' with lines lt 2 title 'semi-implicit, separate', \
  '' using 'time_s':(column('exponential_m') > 0 ? column('exponential_m') : NaN) with linespoints lt 1 pt 7 ps 0.4 dt 1 title 'semi-implicit, one twist', \
  '' using 'time_s':'leapfrog_separate_m' with lines lt 4 title 'leapfrog, separate', \
  '' using 'time_s':(column('leapfrog_exponential_m') > 0 ? column('leapfrog_exponential_m') : NaN) with linespoints lt 3 dt 1 pt 9 ps 0.5 title 'leapfrog, one twist'
unset arrow 1; unset arrow 2; unset label 1; unset label 2

set tmargin at screen 0.375; set bmargin at screen 0.08
set key at screen 0.56,0.418 center top horizontal maxrows 1 width 3
set yrange [1e-5:0.3]; set ytics 1e-5,10
set xrange [0.4:4.6]; unset xlabel
set xtics ('forward' 1, 'semi-implicit' 2, 'impulses' 3, 'leapfrog' 4) scale 0
side = 'error of the angle [rad]'; @SIDE
plot stem.'_angles.csv' using (column('scheme') - 0.12):(abs(column('separate_rad'))) with points lt 2 ps 1.4 title 'separate', \
  '' using (column('scheme') + 0.12):(abs(column('exponential_rad'))) with points lt 1 ps 1.5 title 'one twist', \
  '' using (column('scheme') - 0.12):(abs(column('separate_rad'))):(sprintf('%.2g', column('separate_rad'))) with labels offset -0.6,0.9 notitle, \
  '' using (column('scheme') + 0.12):(abs(column('exponential_rad'))):(sprintf('%.2g', column('exponential_rad'))) with labels offset 0.6,-0.9 notitle
