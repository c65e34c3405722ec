# Four moments of a body that breaks.
tall = 470
@PAGE
set multiplot
do for [k=1:4] {
  column = (k - 1) % 2
  row = (k - 1) / 2
  set origin 0.5*column,0.5*(1 - row) + 0.0
  set size 0.5,0.42
  stats stem.'.csv' using 'time_s' every ::(k - 1)::(k - 1) name 'shown' nooutput
  set label 1 sprintf('%.1f ms', 1000*shown_max) at screen 0.5*column + 0.25,0.5*(1 - row) + 0.455 center textcolor rgb '#202020'
  load stem.'_frame'.k.'.gp'
}
