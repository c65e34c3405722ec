# Chatter in the end of figures 6.6 and 6.7, for two dampings; a dot is a seed.
tall = 500
@PAGE
set lmargin at screen 0.17; set rmargin at screen 0.95
set tmargin at screen 0.85; set bmargin at screen 0.2
set key at screen 0.56,0.985 center top vertical maxcols 2
set xlabel 'damping, k\_scale' offset 0,0.3
set xrange [0.5:2.5]; set xtics (1, 2)
set yrange [0:*]
side = 'chatter at the end [mm]'; @SIDE
plot stem.'.csv' using (column('k_scale')-0.08):(column('figure') < 6.65 ? column('chatter_mm') : NaN) with points lt 1 title 'figure 6.6', \
  '' using (column('k_scale')+0.08):(column('figure') > 6.65 ? column('chatter_mm') : NaN) with points lt 2 title 'figure 6.7'
