# Restarts of the search for an impact, against the time step.
tall = 720
@PAGE
# Before the axes are logarithmic: in short runs none is hidden.
stats stem.'.csv' using 'restarts' every ::2::2 name 'sixtieth' nooutput
stats stem.'.csv' using 'uncovered' every ::2::2 name 'hidden' nooutput
set lmargin at screen 0.18; set rmargin at screen 0.95
set tmargin at screen 0.87; set bmargin at screen 0.135
set logscale xy
set xrange [1.0/600:1.0/12]
set yrange [2e-5:2]; set ytics 1e-5,10; set format y powers
set xtics ('1/480' 1.0/480, '1/240' 1.0/240, '1/120' 1.0/120, '1/60' 1.0/60, '1/30' 1.0/30, '1/15' 1.0/15)
set xlabel 'time step [s]'
side = 'how often'; @SIDE
set label 1 'confirmed below' at 1.0/480,0.5*sixtieth_mean offset -1,0.7 textcolor rgb soft
set arrow 1 from 1.0/560,0.5*sixtieth_mean to 1.0/60,0.5*sixtieth_mean nohead lt 8 dt (2,4)
set arrow 2 from 1.0/60,0.5*sixtieth_mean to 1.0/60,sixtieth_mean nohead lt 8 dt (2,4)
set key at screen 0.56,0.985 center top vertical maxcols 1
over(x) = x > 0 ? x : 2e-5
plot stem.'.csv' using 'step_s':'restarts' with lines lt 1 title 'restarts per collision', \
  '' using 'step_s':'restarts':'restarts_low':'restarts_high' with yerrorbars lt 1 notitle, \
  '' using 'step_s':'uncovered' with lines lt 2 title 'searches that uncover a hidden collision', \
  '' using 'step_s':'uncovered':(over(column('uncovered_low'))):'uncovered_high' with yerrorbars lt 2 notitle, \
  sixtieth_mean*60*x with lines lt 8 dt (2,4) title 'slopes 1 and 2', \
  hidden_mean*3600*x**2 with lines lt 8 dt (2,4) notitle
