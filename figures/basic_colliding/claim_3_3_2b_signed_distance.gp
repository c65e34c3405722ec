# Operations of the signed distance, and how wrong the last closest face is as a normal.
tall = 1000
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95

set tmargin at screen 0.93; set bmargin at screen 0.715
set style fill solid 1.0 border lc rgb '#ffffff'
set boxwidth 0.6
set xrange [0.4:3.6]
set xtics ('closest face' 1, "distance\ninside" 2, "distance\noutside" 3) scale 0
set yrange [0:65]; set ytics 0,20
side = 'operations'; @SIDE
set key at screen 0.56,0.99 center top horizontal samplen 1.5
sums(n) = column('sums'); products(n) = sums(0) + column('products')
divisions(n) = products(0) + column('divisions'); choices(n) = divisions(0) + column('choices')
plot stem.'.csv' using 'kind':(choices(0)) with boxes dt 1 lc rgb '#BBBBBB' title '< max abs', \
  '' using 'kind':(divisions(0)) with boxes dt 1 lc rgb '#D55E00' title '÷ √', \
  '' using 'kind':(products(0)) with boxes dt 1 lc rgb '#56B4E9' title '×', \
  '' using 'kind':(sums(0)) with boxes dt 1 lc rgb '#0072B2' title '+ −', \
  '' using 'kind':(choices(0)):(sprintf('%g arithmetic', divisions(0))) with labels offset 0,0.7 notitle

set tmargin at screen 0.605; set bmargin at screen 0.42
set xrange [-6:96]
set xtics auto
set xtics 0,30 scale 1
set mxtics 3
set xlabel 'angle from last frame’s face to the true normal [°]' offset 0,0.3
set logscale y
set yrange [0.001:1.5]; set ytics 0.001,10; set format y powers
set boxwidth 4
side = 'fraction'; @SIDE
set key at screen 0.95,0.615 right top vertical maxcols 1 samplen 1.5
angles = stem.'_angles.csv'
plot angles using (column('angle_deg') - 2):'inside' with boxes dt 1 lc rgb '#009E73' title 'inside', \
  '' using (column('angle_deg') + 2):'outside' with boxes dt 1 lc rgb '#E69F00' title 'outside'

set tmargin at screen 0.26; set bmargin at screen 0.095
unset logscale y
set logscale x
set xrange [0.007:0.32]
set xtics (0.01, 0.02, 0.05, 0.1, 0.2)
set xlabel 'distance in a frame, over the edge of the box' offset 0,0.3
set yrange [0:40]; set ytics 0,20; set format y '%g'
side = 'off > 10° [%]'; @SIDE
set key at screen 0.56,0.325 center top horizontal
speeds = stem.'_speeds.csv'
plot speeds using 'travel':(100*column('inside')) with linespoints lt 3 title 'inside', \
  '' using 'travel':(100*column('outside')) with linespoints lt 5 title 'outside', \
  '' using 'travel':(100*column('outside_now')) with linespoints lt 8 title 'outside, no delay'
