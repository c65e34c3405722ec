# Amplitudes of the settled clump, and the share that chatters for constants that the thesis does not give.
tall = 1060
@PAGE
stats stem.'_still.csv' using 'bodies' name 'all' nooutput
stats stem.'_still.csv' using 'still' name 'still' nooutput
stats stem.'_still.csv' using 'chattering' name 'chatter' nooutput
stats stem.'_still.csv' using 'restless' name 'restless' nooutput
calm = still_max/all_max
loud = chatter_max/all_max
away = restless_max/all_max
limit = 1e-3
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955

set tmargin at screen 0.965; set bmargin at screen 0.54
side = 'bodies that move less'; @SIDE
set logscale x
set format x powers
set xrange [2e-5:2e-2]; set xtics 1e-5,10
set yrange [0:1]; set ytics 0,0.25
set xlabel 'amplitude, mean over half seconds [edges]' offset 0,0.2
set object 1 rectangle from limit,graph 0 to graph 1,graph 1 fc rgb '#fbe3d6' fs solid noborder behind
set object 2 rectangle from graph 0,first (1 - away) to graph 1,graph 1 fc rgb '#dddddd' fs solid noborder behind
set arrow 1 from limit,graph 0 to limit,graph 1 nohead lt 8 dt (6,4)
set label 1 sprintf('%.0f %% chatter', 100*loud) at screen 0.945,first 0.2 right textcolor rgb '#A04000'
set label 2 sprintf('%.0f %% rest and do not move', 100*calm) at graph 0.03,first (calm - 0.045) left textcolor rgb '#005A8C'
set label 3 sprintf('%.0f %% do not rest', 100*away) at graph 0.03,first (1 - 0.5*away) left textcolor rgb '#202020'
set label 4 'one thousandth' at limit,first 0.06 right offset -0.6,0 textcolor rgb soft
stats stem.'.csv' using 'amplitude' name 'moving' nooutput
set arrow 2 from graph 0,first calm to moving_min,calm nohead lc rgb '#0072B2' lw 3
plot stem.'.csv' using 'amplitude':'share' with lines lt 1 lw 3 notitle

unset object; unset arrow; unset label
set tmargin at screen 0.375; set bmargin at screen 0.095
side = 'fraction that chatters'; @SIDE
set logscale x 2
set format x '%g'
set xrange [0.42:2.38]; set xtics ('half' 0.5, 'as it is' 1, 'twice' 2)
set yrange [-0.04:1.04]
set xlabel 'constants that the thesis does not give' offset 0,0.2
set arrow 1 from graph 0,first 0.05 to graph 1,first 0.05 nohead lt 8 dt (6,4)
set label 1 'confirmed above' at 1.75,0.105 right textcolor rgb soft
set key at screen 0.56,0.447 center top horizontal
factor(v) = (v == 0) ? 1.0 : (int(v) % 2 == 1) ? 0.5 : 2.0
series(v, first) = (v == 0 || v == first || v == first + 1) ? column('share') : NaN
shares = stem.'_shares.csv'
set datafile missing NaN
plot shares using (factor(column('variant'))*0.95):(series(column('variant'), 1)):'low':'high' with yerrorbars lt 1 ps 1.2 title 'thresholds', \
  '' using (factor(column('variant'))):(series(column('variant'), 3)):'low':'high' with yerrorbars lt 2 ps 1.2 title 'damping factors', \
  '' using (factor(column('variant'))*1.05):(series(column('variant'), 5)):'low':'high' with yerrorbars lt 3 ps 1.2 title 'passes'
