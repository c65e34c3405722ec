# How far things go, each seed under both techniques: on the diagonal both agree.
tall = 1180
@PAGE
mark = form eq 'svg' ? 0.5 : 1  # size of marks
set multiplot
medians = stem.'_medians.csv'
set lmargin at screen 0.17; set rmargin at screen 0.955
set style fill solid 1.0 noborder
do for [s=0:1] {
  stats stem.'.csv' using (column('scene') == s ? column('damped_m') : NaN) name 'd' nooutput
  stats stem.'.csv' using (column('scene') == s ? column('coulomb_m') : NaN) name 'c' nooutput
  most = 1.12*(d_max > c_max ? d_max : c_max)
  set tmargin at screen (s == 0 ? 0.95 : 0.455); set bmargin at screen (s == 0 ? 0.595 : 0.115)
  set xrange [0:most]; set yrange [0:most]
  set label 1 (s == 0 ? 'a cube is shot at a pyramid' : 'cubes fly together and settle') at graph 0.5,1.045 center textcolor rgb '#202020'
  set xlabel 'mean distance of a box, Coulomb [m]' offset 0,0.2
  side = 'the same, damped [m]'; @SIDE
  set key at graph 0.02,0.985 left top vertical maxcols 1 samplen 2
  set samples 200
  plot '+' using 1:(0.9*$1):(1.1*$1 < most ? 1.1*$1 : most) with filledcurves lc rgb '#dddddd' title 'a tenth off', \
    x with lines lt 8 title 'equal', \
    stem.'.csv' using (column('scene') == s ? column('coulomb_m') : NaN):'damped_m' with points lt 1 ps mark title 'a seed', \
    medians using (column('scene') == s ? column('coulomb_m') : NaN):'damped_m' with points pt 2 ps 2.6*mark lw 4 lc rgb '#D55E00' title 'medians'
}
