# Time until dice rest, against which collisions are left to chance.
tall = 800
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.89; set bmargin at screen 0.62
set xrange [0.4:4.6]
set xtics ('nowhere' 1, 'fast' 2, 'slow' 3, 'all' 4) scale 0
set xlabel 'collisions that are varied at random' offset 0,0.2
set yrange [0:*]; set ytics 0,1
set boxwidth 0.35
set style fill solid 1.0 border lc rgb '#ffffff'
side = 'time to rest [s]'; @SIDE
set key at screen 0.56,0.985 center top horizontal
plot stem.'.csv' using (column('rule') - 0.18):'rest_s' with boxes dt 1 lc rgb '#0072B2' title 'all of the damping', \
  '' using (column('rule') + 0.18):'rest_scaled_s' with boxes dt 1 lc rgb '#E69F00' title 'scaling only'

set tmargin at screen 0.395; set bmargin at screen 0.14
set xrange [0:1]; set xtics 0,0.2 scale 1
set xlabel 'time [s]' offset 0,0.2
set yrange [-5:400]; set ytics 0,100
side = 'height [mm]'; @SIDE
set key at screen 0.56,0.485 center top vertical maxcols 1
path = stem.'_path.csv'
plot path using 'time_s':'fast_mm' with lines lt 1 title 'randomness in fast collisions', \
  '' using 'time_s':'all_mm' with lines lt 2 title 'in all'
