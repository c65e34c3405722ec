# Speed, chatter and overlap of a stack of ten, and overlap under a heavy load, by technique.
tall = 1240
@PAGE
set multiplot
array names[15] = ['contact\_damped', 'basic', 'analytic', 'time\_stepping', 'impulse', 'damped', 'timewarp\_simple', 'timewarp\_safer', 'timewarp\_swept', 'timewarp\_full', 'glued', 'penalty', 'faure', 'relaxation', 'settling']
set lmargin at screen 0.285; set rmargin at screen 0.955
set logscale x
set xrange [1e-10:3e4]; set xtics 1e-9,1e3; set format x powers; set xtics add ('≤10^{–9}' 1e-9); unset mxtics
set yrange [14.6:-0.6]
set border 1 lc rgb '#808080'; unset grid; set grid x
set ytics scale 0 ('' -5)
set for [k = 1:15] ytics add (names[k] k - 1)
# What is less than 1e-9 is shown there; what was not measured is not shown.
shown(v) = v > 1e-9 ? v : (v <= 1e-9 ? 1e-9 : NaN)

set key at screen 0.6,0.992 center top horizontal samplen 1 width -1
set tmargin at screen 0.915; set bmargin at screen 0.56
set xlabel 'stack of ten: mm, and mm/s for the speed' offset 0,0.3
plot stem.'.csv' using (shown(1e3*column('stack_m_s'))):'technique' with points pt 7 ps 1.1 lc rgb '#0072B2' title 'speed at the end', \
  '' using (shown(1e3*column('chatter_m'))):'technique' with points pt 6 ps 1.7 lw 2 lc rgb '#D55E00' title 'chatter', \
  '' using (shown(1e3*column('overlap_m'))):'technique' with points pt 2 ps 1.3 lw 2 lc rgb '#009E73' title 'deepest overlap', \
  '' using (valid(3) ? NaN : 1e-9):'technique':('does not stand') with labels left textcolor rgb soft notitle

set key at screen 0.6,0.465 center top vertical maxrows 1 samplen 1
set tmargin at screen 0.43; set bmargin at screen 0.075
set xlabel 'overlap under a heavier cube [mm]' offset 0,0.3
plot stem.'.csv' using (shown(1e3*column('mass10_m'))):'technique' with points pt 7 ps 0.8 lc rgb '#56B4E9' title '10 times', \
  '' using (shown(1e3*column('mass100_m'))):'technique' with points pt 6 ps 1.4 lw 2 lc rgb '#E69F00' title '100', \
  '' using (shown(1e3*column('mass1000_m'))):'technique' with points pt 4 ps 2 lw 2 lc rgb '#4D4D4D' title '1000', \
  '' using (valid(6) ? NaN : 1e-9):'technique':('does not stand') with labels left textcolor rgb soft notitle
