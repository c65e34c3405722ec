# Spectrum, amplitude and squirm of what chatters, raw and under filters.
tall = 900
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
bars = stem.'_measures.csv'
set key at screen 0.56,0.995 center top vertical maxrows 3 width -1

set tmargin at screen 0.885; set bmargin at screen 0.49
set xrange [0:30]; set xtics 0,5
set xlabel 'frequency [Hz]' offset 0,0.3
set logscale y; set format y powers
set yrange [4e-7:4e-3]
side = 'amplitude [m]'; @SIDE
plot stem.'.csv' using 'frequency_hz':'raw_m' with lines lt 8 title 'computed', \
  '' using 'frequency_hz':'box_m' with lines lt 1 title 'box of five', \
  '' using 'frequency_hz':'one_euro_m' with lines lt 2 title 'one-euro', \
  '' using 'frequency_hz':'envelope_m' with lines lt 4 title 'envelope', \
  '' using 'frequency_hz':'soft_envelope_m' with lines lt 3 title 'soft envelope'
unset logscale y; unset key
set format y '%g'

set tmargin at screen 0.37; set bmargin at screen 0.1
set xrange [-0.6:4.6]; unset xlabel
set xtics ('computed' 0, "box\nof five" 1, "soft\nenvelope" 2, 'one-euro' 3, 'envelope' 4) scale 0
set yrange [0:1.2]; set ytics 0,0.5
set style fill solid 1.0 noborder
set boxwidth 0.32
side = 'over that computed'; @SIDE
set key at graph 0.98,graph 1.02 right top vertical maxcols 1
plot bars using (column('filter')-0.18):'amplitude' with boxes lt 1 title 'amplitude', \
  '' using (column('filter')+0.18):'squirm' with boxes lt 5 title 'squirm', \
  '' using (column('filter')-0.18):'amplitude_low':(0):(column('amplitude_high')-column('amplitude_low')) with vectors heads size 0.05,90 lc rgb '#202020' dt 1 lw 1.5 notitle, \
  '' using (column('filter')+0.18):'squirm_low':(0):(column('squirm_high')-column('squirm_low')) with vectors heads size 0.05,90 lc rgb '#202020' dt 1 lw 1.5 notitle, \
  '' using (column('filter')-0.2):'amplitude_high':(sprintf('%.2g', column('amplitude'))) with labels offset 0,0.7 notitle, \
  '' using (column('filter')+0.2):'squirm_high':(sprintf('%.2g', column('squirm'))) with labels offset 0,0.7 notitle
