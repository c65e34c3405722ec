# Three motions, one a row, at three moments each.
tall = 560
@PAGE
set multiplot
do for [row=1:3] {
  do for [column=1:3] {
    set origin (column - 1)/3.0,1 - row/3.0 + 0.035
    set size 1/3.0,0.2976
    set label 1 sprintf('motion %d, %s s', row, word('0.5 0.8 2', column)) at screen (column - 0.5)/3.0,1 - row/3.0 + 0.022 \
      center textcolor rgb '#202020'
    load stem.'_motion'.row.'_'.column.'.gp'
  }
}
