# Shares of settled boxes by tilt.
tall = 580
@PAGE
set lmargin at screen 0.18; set rmargin at screen 0.95
set tmargin at screen 0.76; set bmargin at screen 0.17
set key at screen 0.56,0.98 center top vertical maxcols 1
set logscale x
set xrange [0.01:60]
set xtics (0.01, 0.1, 1, 10)
set yrange [0:1]; set ytics 0,0.25
set xlabel 'tilt of the nearest face [degrees]' offset 0,0.2
side = 'fraction with at most this tilt'; @SIDE
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lt 8 dt (6,4)
set label 1 'face down' at 1,graph 0.1 right offset -0.7,0 textcolor rgb soft
plot stem.'.csv' using 'tilt_deg':'share' with lines lt 1 title 'contact\_damped, all clumps', \
  '' using 'tilt_deg':'share_smallest' with lines lt 3 title 'smallest clumps only', \
  '' using 'tilt_deg':'share_largest' with lines lt 4 title 'largest clumps only', \
  '' using 'tilt_deg':'share_damped' with lines lt 2 title 'damped as in the thesis, all clumps'
