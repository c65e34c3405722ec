# A cube is shot at a pyramid: six moments, three seen from behind and above the start of the shot, three from the other side.
tall = 700
@PAGE
set multiplot
do for [k=1:6] {
  column = (k - 1) % 2
  row = (k - 1) / 2
  set origin 0.5*column,1 - (row + 1)/3.0 + 0.04
  set size 0.5,0.286
  stats stem.'.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf(k > 3 ? '%.2f s, from behind' : '%.2f s', shown_max) at screen 0.5*column + 0.25,1 - (row + 1)/3.0 + 0.022 \
    center textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
}
