# Shares of tossed cubes by travel and by time to rest, with the measured quartiles.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
quartiles = stem.'_quartiles.csv'
side = 'fraction of tosses'
set yrange [0:1]; set ytics 0,0.25
set key at screen 0.56,0.985 center top vertical maxcols 1
set tmargin at screen 0.8; set bmargin at screen 0.525
set xrange [0.2:0.8]; set xtics 0.2,0.1
set xlabel 'travel [m]' offset 0,0.3
@SIDE
plot stem.'.csv' using 'travel_chance_m':'share' with lines lt 1 title 'damped, randomness in fast collisions', \
  '' using 'travel_damped_m':'share' with lines lt 2 title 'damped, no randomness', \
  '' using 'travel_impulse_m':'share' with lines lt 3 title 'impulses alone', \
  '' using 'travel_coulomb_m':'share' with lines lt 4 title 'contact\_damped', \
  quartiles using 'travel_m':'share' with points lt 8 pt 7 ps 1.4 title 'quartiles of measured tosses'

unset key
set tmargin at screen 0.395; set bmargin at screen 0.135
set xrange [0.3:1.2]; set xtics 0.3,0.1
set xlabel 'time to rest [s]' offset 0,0.3
@SIDE
plot stem.'.csv' using 'rest_chance_s':'share' with lines lt 1, \
  '' using 'rest_damped_s':'share' with lines lt 2, \
  '' using 'rest_impulse_s':'share' with lines lt 3, \
  '' using 'rest_coulomb_s':'share' with lines lt 4, \
  quartiles using 'rest_s':'share' with points lt 8 pt 7 ps 1.4
