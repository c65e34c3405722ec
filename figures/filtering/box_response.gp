# The gain of a box filter over five frames against frequency, and the error of what was measured.
tall = 820
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
marks = stem.'_marks.csv'
stats stem.'.csv' using (column('frequency_hz')/column('frequency')) every ::1 nooutput
rate = STATS_max
set xrange [0:0.5]; set xtics 0,0.1

set tmargin at screen 0.825; set bmargin at screen 0.4
set format x ''
set border 7 lc rgb '#808080'
set x2range [0:0.5*rate]; set x2tics 0,6 scale 1 offset 0,-0.3
set x2label sprintf('frequency at %g frames a second [Hz]', rate) offset 0,-0.4
set yrange [-0.42:1.05]; set ytics -0.25,0.25
side = 'gain H'; @SIDE
set key at screen 0.56,0.995 center top horizontal maxcols 2 width -1
set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead lc rgb '#404040' lw 1
set label 1 'shown inverted' at 0.3,0.055 center textcolor rgb soft
plot stem.'.csv' using 'frequency':(column('exact') < 0 ? column('exact') : 0) with filledcurves y=0 fc rgb '#F2C6A8' notitle, \
  '' using 'frequency':'exact' with lines lt 8 title 'closed form', \
  '' using 'frequency':'moves' every 8 with points lt 1 title 'a body moves', \
  '' using 'frequency':'turns' every 8::4 with points lt 2 title 'a body turns', \
  marks using 'frequency':'gain' with points pt 6 ps 1.7 lw 2 lc rgb '#202020' notitle, \
  marks using 'frequency':'gain':(column('kind') == 0 ? sprintf('%.1f', column('frequency')) : '') with labels offset 0.2,1.1 notitle, \
  marks using 'frequency':'gain':(column('kind') == 1 ? sprintf('lowest, %.2f at %.4f', column('gain'), column('frequency')) : '') with labels offset 0,-1.1 notitle, \
  marks using 'frequency':'gain':(column('kind') == 2 ? sprintf('  -3 dB at %.4f', column('frequency')) : '') with labels left offset 0.8,0.3 notitle, \
  stem.'.csv' using 'frequency':'exact':(column('frequency') == 0.5 ? sprintf('%.1f', column('exact')) : '') with labels right offset -0.2,0.9 notitle
unset key; unset arrow 1; unset label 1
unset x2tics; unset x2label
@AXES

set tmargin at screen 0.34; set bmargin at screen 0.105
set format x '%g'
set xlabel 'frequency [cycles a frame]' offset 0,0.3
set logscale y; set format y powers
set yrange [3e-18:1e-7]; set ytics 1e-17,1e3
side = 'largest error / amplitude'; @SIDE
set arrow 2 from graph 0,first 1e-9 to graph 1,first 1e-9 nohead lt 8 dt (6,4)
set label 2 'asked: 10^{-9}' at 0.49,4e-9 right textcolor rgb soft
plot stem.'.csv' using 'frequency':'error_moves' with lines lt 1, \
  '' using 'frequency':'error_turns' with lines lt 2
