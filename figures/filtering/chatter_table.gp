# Chatter of every technique, scene by scene: shaded by amplitude, with ranks; below, techniques without rest.
tall = 1330
@PAGE
set macros
rows = 7
table = stem.'.csv'
array cubes[4]
do for [s=0:3] {
  stats table using (column('scene') == s ? column('cubes') : NaN) name 'one' nooutput
  cubes[s+1] = sprintf('%d', one_max)
}
bar = stem.'_bar.csv'
stats bar using 'amplitude_m' name 'shade' nooutput

set multiplot
unset key; unset border; unset tics; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98

# Lengths as words.
short(x) = x < 0.9995e-9 ? '< 1 nm' : x < 0.9995e-6 ? sprintf('%.0f nm', 1e9*x) : x < 0.9995e-5 ? sprintf('%.1f µm', 1e6*x) : x < 0.9995e-3 ? sprintf('%.0f µm', 1e6*x) : sprintf('%.1f mm', 1e3*x)
range(a,b) = b < 1e-9 ? '' : short(a).' – '.short(b)
shake(g) = g < 1e-3 ? '< 0.001 g' : sprintf('%.2g g', g)
place(r,tie) = sprintf('%d%s', r, tie > 0 ? '=' : '')

set tmargin at screen 1 - 58.0/tall; set bmargin at screen 1 - 866.0/tall
set xrange [0:4]; set yrange [rows:0]
set label 1 'stack of '.cubes[1] at 0.5,graph 1 center offset 0,1.55
set label 2 'pyramid of '.cubes[2] at 1.5,graph 1 center offset 0,1.55
set label 3 'clump of '.cubes[3] at 2.5,graph 1 center offset 0,1.55
set label 4 'clump of '.cubes[4] at 3.5,graph 1 center offset 0,1.55
names = '"impulse" "damped" "damped, the printed listings repaired" "contact\_damped" "analytic, with damping for friction" "analytic, with Coulomb friction" "time\_stepping"'
do for [t=1:rows] { set label 10+t word(names, t) at 0.02,t-0.91 left textcolor rgb '#005A8C' }
small = form eq 'svg' ? ',15' : ',10.8'
T = "column('technique')"; S = "column('scene')"
ranked(c) = strlen(stringcolumn(c)) > 0
set style fill solid 1.0 noborder
plot table using (@S+0.5):(@T+0.58):(@S+0.015):(@S+0.985):(@T+0.19):(@T+0.975):'colour' with boxxyerror lc rgb variable, \
  '' using (@S+0.06):(@T+0.32):(column('run') == 0 ? 'too slow' : ranked('rank') ? short(column('amplitude_m')) : column('unsolved') > 0 ? 'not solved' : column('fell') > 0 ? sprintf('fell in %d of %d', column('fell'), column('all_cubes')/column('cubes')) : 'does not rest') with labels left textcolor rgb '#101010', \
  '' using (@S+0.95):(@T+0.32):(ranked('rank') ? place(column('rank'), column('tied')) : '') with labels right textcolor rgb '#A04000', \
  '' using (@S+0.06):(@T+0.51):(column('run') == 0 ? '' : ranked('rank') ? range(column('amplitude_low_m'), column('amplitude_high_m')) : 'else '.short(column('amplitude_m'))) with labels left font small textcolor rgb '#303030', \
  '' using (@S+0.06):(@T+0.69):(column('run') == 0 ? '' : shake(column('acceleration'))) with labels left font small textcolor rgb '#303030', \
  '' using (@S+0.06):(@T+0.87):(column('run') == 0 || column('restless') == 0 ? '' : sprintf('%d of %d move', column('restless'), column('all_cubes'))) with labels left font small textcolor rgb '#303030'
unset label

# The colours.
set tmargin at screen 1 - 880.0/tall; set bmargin at screen 1 - 902.0/tall
set lmargin at screen 0.06; set rmargin at screen 0.94
set border 15 lc rgb '#808080'
set yrange [0:1]; set logscale x; set xrange [shade_min:shade_max]
set xtics ('1 nm' 1e-9, '1 µm' 1e-6, '1 mm' 1e-3, '10 mm' 1e-2) scale 0.6 nomirror textcolor rgb '#303030'
set label 1 'median amplitude of the cube that shakes most; below it the range,' at screen 0.5,1 - 958.0/tall center font small
set label 2 'and acceleration. Brown: 1 + how many are surely calmer, = if shared.' at screen 0.5,1 - 980.0/tall center font small
step = (shade_max/shade_min)**(0.5/(shade_records - 1))
plot bar using 'amplitude_m':(0.5):(column('amplitude_m')/step):(column('amplitude_m')*step):(0):(1):'colour' with boxxyerror lc rgb variable
unset label; unset border; unset tics; unset logscale x

# Techniques without resting contact, on the stack.
set tmargin at screen 1 - 1030.0/tall; set bmargin at screen 15.0/tall
set lmargin at screen 0.02; set rmargin at screen 0.98
set xrange [0:4]; set yrange [5:0]
set label 1 'without resting contact, on the stack:' at 0.02,graph 1 left offset 0,0.9 textcolor rgb '#202020'
other = '"basic" "timewarp\_simple" "timewarp\_safer" "timewarp\_swept" "timewarp\_full"'
do for [t=1:5] { set label 10+t word(other, t) at 0.02,t-0.72 left textcolor rgb '#005A8C' }
why(t) = t == 0 ? 'flies on and falls from impact to impact' : 'what lies is stopped at each frame''s end'
plot stem.'_without.csv' using (1.42):(column('technique')+0.28):(why(column('technique'))) with labels left font small, \
  '' using (1.42):(column('technique')+0.66):(sprintf('%.1f collisions a step%s%s%s', column('collisions'), column('capped') > 0 ? sprintf(', cap met in %.0f %%', 100*column('capped')) : '', column('fell') > 0 ? sprintf(', fell in %d of %d', column('fell'), column('seeds')) : '', ranked('amplitude_m') && column('fell') == 0 ? ', '.short(column('amplitude_m')).' in half a second' : '')) with labels left font small textcolor rgb soft
