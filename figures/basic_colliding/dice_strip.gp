# A thrown die in six frames, from left to right and from above to below.
tall = 600
@PAGE
set multiplot
stats stem.'.csv' using 'time_s' name 'frame' nooutput
do for [k=1:6] {
  column = (k - 1) % 2
  row = (k - 1) / 2
  set origin 0.5*column,1 - (row + 1)/3.0 + 0.035
  set size 0.5,0.29
  stats stem.'.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.2f s', shown_max) at screen 0.5*column + 0.25,1 - (row + 1)/3.0 + 0.02 \
    center textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
}
