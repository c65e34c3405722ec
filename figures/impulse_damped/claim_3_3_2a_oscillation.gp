# Chatter of a stack against the time step: shock by pushes or velocities, one point or the area.
tall = 940
@PAGE
set multiplot
set logscale xy
set xrange [0.0017:0.041]
set yrange [1e-6:1]
lowest = 2e-6   # where zeros are marked
highest = 0.24  # where it is marked that no box rests
array names[3] = ['closest face of the last step', 'exact normal', 'gradient of the distance']
array left[2] = [0.18, 0.61]
array right[2] = [0.55, 0.975]
array top[2] = [0.865, 0.475]
array bottom[2] = [0.53, 0.14]
array points[2] = ['one point', 'area']
array shocks[2] = ['pushes', 'velocities']
mine(s, p, n) = column('shock') == s && column('points') == p && column('normals') == n
rests(s, p, n) = mine(s, p, n) && column('windows') > 0
# Marks of the three rules stand beside each other.
beside(n) = column('dt_s')*1.08**(n - 1)
curve(s, p, n) = rests(s, p, n) && column('amplitude_m') > 1e-9 ? column('dt_s') : NaN
zero(s, p, n) = rests(s, p, n) && column('amplitude_m') <= 1e-9 ? beside(n) : NaN
restless(s, p, n) = mine(s, p, n) && column('windows') == 0 ? beside(n) : NaN
# A point that is elsewhere breaks the line.
height(s, p, n) = curve(s, p, n) > 0 ? column('amplitude_m') : NaN

set arrow 1 from 1.0/60,graph 0 to 1.0/60,graph 1 nohead lt 8 dt (6,4)
set arrow 2 from graph 0,first 0.15 to graph 1,first 0.15 nohead lt 8 lw 1 lc rgb '#808080'
set label 3 'no box rests' at 1.0/480,0.6 left textcolor rgb soft
set ytics 1e-6,10,1e-1
set key at screen 0.57,0.99 center top vertical maxcols 1
set xtics ('' 1.0/480, '' 1.0/120, '' 1.0/30)
do for [s = 0:1] {
  if (s == 1) {
    set xtics ('1/480' 1.0/480, '1/120' 1.0/120, '1/30' 1.0/30)
    set label 2 'time step [s]' at screen 0.58,0.065 center textcolor rgb '#202020'
  }
  do for [p = 0:1] {
    set lmargin at screen left[p+1]; set rmargin at screen right[p+1]
    set tmargin at screen top[s+1]; set bmargin at screen bottom[s+1]
    set label 1 shocks[s+1].', '.points[p+1] at graph 0.5,1.045 center textcolor rgb soft
    if (p == 0) {
      set format y powers; side = 'amplitude of chatter [m]'; @SIDE
    } else {
      set format y ''; unset label 99
    }
    plot for [n = 0:2] stem.'.csv' using (curve(s,p,n)):(height(s,p,n)) \
        with linespoints lt n+1 title names[n+1], \
      for [n = 0:2] '' using (zero(s,p,n)):(lowest):('0') \
        with labels center offset 0,0.8 point lt n+1 notitle, \
      for [n = 0:2] '' using (restless(s,p,n)):(highest) with points lt n+1 notitle
    unset key; unset label 3
  }
}
unset multiplot
