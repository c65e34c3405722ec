# Two envelopes of many sizes on the settled clump: rest, pops, steps, speed, overlap.
tall = 1480
@PAGE
set multiplot
set lmargin at screen 0.17; set rmargin at screen 0.955
set logscale x
set xrange [0.85:60]
set xtics ('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50)
stats stem.'_raw.csv' using 'speed_mm_s' name 'speed' nooutput
stats stem.'_raw.csv' using 'step_mm' name 'step' nooutput
stats stem.'_raw.csv' using 'standard_mm' name 'standard' nooutput
set arrow 1 from standard_max,graph 0 to standard_max,graph 1 nohead lt 8 dt (6,4) back

set tmargin at screen 0.955; set bmargin at screen 0.8
side = 'frames at rest'; @SIDE
set yrange [0.35:1.03]; set ytics 0.4,0.2
set label 2 'nine of ten' at graph 0.985,first 0.855 right textcolor rgb soft
set key at screen 0.56,0.995 center top horizontal
plot 0.9 with lines lt 8 notitle, \
  stem.'.csv' using 'radius_mm':'thesis_still' with linespoints lt 1 title 'envelope', \
  '' using 'radius_mm':'thesis_still':'thesis_still_low':'thesis_still_high' with yerrorbars lt 1 notitle, \
  '' using 'radius_mm':'soft_still' with linespoints lt 2 title 'soft envelope', \
  '' using 'radius_mm':'soft_still':'soft_still_low':'soft_still_high' with yerrorbars lt 2 notitle
unset key; unset label 2

set tmargin at screen 0.745; set bmargin at screen 0.595
side = 'pops per minute'; @SIDE
# No pop at all lies on the lowest line.
set logscale y; set yrange [0.1:3000]; set ytics ('none' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000)
on(p) = p > 0.1 ? p : 0.1
plot stem.'.csv' using 'radius_mm':(on(column('thesis_pops'))) with linespoints lt 1, \
  '' using 'radius_mm':(on(column('thesis_pops'))):(on(column('thesis_pops_low'))):'thesis_pops_high' with yerrorbars lt 1, \
  '' using 'radius_mm':(on(column('soft_pops'))) with linespoints lt 2, \
  '' using 'radius_mm':(on(column('soft_pops'))):(on(column('soft_pops_low'))):'soft_pops_high' with yerrorbars lt 2

set tmargin at screen 0.555; set bmargin at screen 0.425
side = 'longest step [mm]'; @SIDE
set yrange [1:200]; set ytics (1, 10, 100)
set label 2 'computed' at graph 0.985,first step_max*1.9 right textcolor rgb soft
plot step_max with lines lt 8, \
  stem.'.csv' using 'radius_mm':'thesis_step_mm' with linespoints lt 1, \
  '' using 'radius_mm':'soft_step_mm' with linespoints lt 2

set tmargin at screen 0.385; set bmargin at screen 0.255
side = 'speed [mm/s]'; @SIDE
set yrange [0.2:200]; set ytics (1, 10, 100)
set label 2 'computed' at graph 0.985,first speed_max*0.4 right textcolor rgb soft
plot speed_max with lines lt 8, \
  stem.'.csv' using 'radius_mm':'thesis_speed_mm_s' with linespoints lt 1, \
  '' using 'radius_mm':'soft_speed_mm_s' with linespoints lt 2
unset label 2

set tmargin at screen 0.215; set bmargin at screen 0.065
side = 'overlap added [mm]'; @SIDE
set yrange [0.2:200]; set ytics (1, 10, 100)
set xlabel 'radius of the envelope [mm], a degree per 10 mm' offset 0,0.3
plot stem.'.csv' using 'radius_mm':'thesis_overlap_mm' with linespoints lt 1, \
  '' using 'radius_mm':'soft_overlap_mm' with linespoints lt 2
