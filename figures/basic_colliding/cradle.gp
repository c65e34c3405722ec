# Newton's cradle: velocities before and after, in two readings.
tall = 640
@PAGE
set multiplot
stats stem.'.csv' using 'box' name 'row' nooutput
columns = 'before_m_s simultaneous_m_s sequential_m_s'
array sums[3]; array squares[3]
do for [i=1:3] {
  stats stem.'.csv' using word(columns, i) name 'all' nooutput
  sums[i] = all_sum; squares[i] = all_sumsq
}
set lmargin at screen 0.18; set rmargin at screen 0.95
set boxwidth 0.7
set style fill solid 0.85 border lc rgb '#303030'
set xrange [0.4:row_max + 0.6]
set yrange [-0.95:1.4]; set ytics -1,0.5
set xtics 1 scale 0
set xzeroaxis lt 8 lw 1
unset key
side = 'velocity [m/s]'; @SIDE
titles = '"before" "after, all impulses at once" "after, one impulse after the other"'
colours = '#9a9a9a #0072B2 #D55E00'
above(value) = value >= 0 ? value + 0.19 : value - 0.19
shown(value) = sprintf('%.3g', abs(value) < 1e-12 ? 0 : value)
do for [i=1:3] {
  set tmargin at screen 0.95 - 0.285*(i - 1)
  set bmargin at screen 0.73 - 0.285*(i - 1)
  what = word(columns, i)
  set label 2 sprintf('Σ v = %s m/s,  Σ v² = %s m²/s²', shown(sums[i]), shown(squares[i])) \
    at graph 0.985,0.12 right textcolor rgb soft
  set format x (i == 3 ? '%g' : '')
  if (i == 3) { set xlabel 'box, from left to right' }
  set label 1 word(titles, i) at graph 0.5,1.08 center textcolor rgb '#202020'
  plot stem.'.csv' using 'box':what with boxes lc rgb word(colours, i), \
    '' using 'box':(above(column(what))):(shown(column(what))) with labels
}
