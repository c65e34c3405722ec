# The crane in four frames, from left to right and from above to below.
tall = 600
@PAGE
set multiplot
do for [k=1:4] {
  column = (k - 1) % 2
  row = (k - 1) / 2
  set origin 0.5*column,1 - (row + 1)/2.0 + 0.05
  set size 0.5,0.44
  stats stem.'_shown.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.1f s', shown_max) at screen 0.5*column + 0.25,1 - (row + 1)/2.0 + 0.025 \
    center textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
}
