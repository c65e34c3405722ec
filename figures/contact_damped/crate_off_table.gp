# A crate slides off a table and tumbles: on the left damped, on the right with Coulomb's friction.
tall = 860
@PAGE
set multiplot
set label 90 'damped' at screen 0.25,0.98 center
set label 91 'Coulomb' at screen 0.75,0.98 center
do for [k=1:8] {
  column = (k - 1) / 4
  row = (k - 1) % 4
  set origin 0.5*column,0.96 - 0.24*(row + 1) + 0.03
  set size 0.5,0.21
  set autoscale
  stats stem.'.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.2f s', shown_max) at screen 0.5*column + 0.035,0.96 - 0.24*(row + 1) + 0.225 left front textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
  unset label 90; unset label 91
}
