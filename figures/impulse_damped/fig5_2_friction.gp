# Block A on block B: forces between them, speeds and momentum, damped and with Coulomb's friction.
tall = 960
@PAGE
set multiplot
blocks = stem.'_blocks.csv'
stats stem.'.csv' using 'time_s' name 'time' nooutput
stats blocks using 'damped_N' every ::0::0 name 'upper_damped' nooutput
stats blocks using 'coulomb_N' every ::0::0 name 'upper_coulomb' nooutput
stats blocks using 'coulomb_N' every ::1::1 name 'lower_coulomb' nooutput
stats blocks using 'damped_N' every ::1::1 name 'lower_damped' nooutput

# The blocks and what friction does to each, seen from the side.
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin at screen 0.99; set bmargin at screen 0.755
set xrange [-2.5:2.5]; set yrange [-0.22:1.66]
set style fill solid 1.0 border lc rgb '#808080'
long = 0.1  # [m] of arrow for a newton
set arrow 1 from -2.5,0 to 2.5,0 nohead lw 1.5 lc rgb '#808080'
set arrow 2 from -1.15,0.6 to -0.4,0.6 head filled size 0.09,22 fixed lw 2 dt 1 lc rgb '#808080'
set label 1 'velocity of A' at -0.33,0.6 left textcolor rgb soft
set label 2 'A' at -1.5,0.6 center front font ',22'
set label 3 'B' at -1.2,0.2 center front font ',22'
at_a = -1.82
# The head is drawn for itself: a dashed line would be dashed in it too.
set arrow 3 from at_a,0.70 rto long*upper_coulomb_max + 0.08,0 nohead lt 2 lw 3.5 front
set arrow 6 from at_a + long*upper_coulomb_max + 0.1,0.70 rto -0.1,0 head size 0.09,22 fixed filled lt 2 dt 1 lw 3.5 front
set arrow 4 from at_a,0.51 rto long*upper_damped_max,0 head size 0.09,22 fixed filled lt 1 lw 3.5 front
set label 4 sprintf('on A, Coulomb %.1f N', -upper_coulomb_max) at -2.4,1.34 left textcolor rgb '#B24E00'
set label 5 sprintf('on A, damped %.1f N', -upper_damped_max) at -2.4,1.06 left textcolor rgb '#0072B2'
set arrow 5 from -0.9,0.2 rto long*lower_coulomb_max - 0.08,0 nohead lt 2 lw 3.5 front
set arrow 7 from -1.0 + long*lower_coulomb_max,0.2 rto 0.1,0 head size 0.09,22 fixed filled lt 2 dt 1 lw 3.5 front
set label 6 sprintf('Coulomb %.1f N; damped %s', lower_coulomb_max, abs(lower_damped_max) < 0.05 ? 'none' : sprintf('%.1f N', lower_damped_max)) \
  at -0.35,0.2 left front textcolor rgb '#202020'
plot blocks using 'x_m':'y_m':(0.5*column('width_m')):(0.5*column('height_m')) with boxxy lc rgb '#e3e8ec'
unset arrow; unset label
@AXES
set xtics nomirror; set ytics nomirror
set lmargin at screen 0.17; set rmargin at screen 0.955
set xrange [0:time_max]

# Speeds.
set tmargin at screen 0.715; set bmargin at screen 0.41
set format x ''
set yrange [-0.08:*]
side = 'speed [m/s]'; @SIDE
set key at graph 0.99,0.985 right top vertical maxcols 1 samplen 3
plot stem.'.csv' using 'time_s':'damped_a_m_s' with lines lt 1 title 'A, damped', \
  '' using 'time_s':'damped_b_m_s' with lines lt 1 lc rgb '#56B4E9' title 'B, damped', \
  '' using 'time_s':'coulomb_a_m_s' with lines lt 2 title 'A, Coulomb', \
  '' using 'time_s':'coulomb_b_m_s' with lines lt 2 lc rgb '#E69F00' title 'B, Coulomb'

# Momentum of both.
set tmargin at screen 0.365; set bmargin at screen 0.115
set format x '%g'
set xlabel 'time [s]'
side = 'momentum [kg m/s]'; @SIDE
set key at graph 0.99,0.70
plot stem.'.csv' using 'time_s':'damped_momentum' with lines lt 1 title 'both, damped', \
  '' using 'time_s':'coulomb_momentum' with lines lt 2 title 'both, Coulomb'
