# One look for all figures.
#
# figures/draw runs this file and then the figure's own script in one gnuplot, with
#   form  'svg' or 'png'
#   stem  path of the figure's files without ending: stem.'.csv' is its main table
#   out   the picture to write
# The figure's script begins with `tall = ...` (height in points, width is 600) and
# @PAGE, then draws; @AXES brings the axes back after a drawing without them, and
# side = 'height [m]'; @SIDE writes beside an axis, wherever its tic labels end.
#
# Pictures are as wide as a column of text and panels stand one above the other: on a phone, where
# 600 points shrink to 360, the letters still have 11 points.

wide = 600
svg = 'set terminal svg size wide,tall dynamic font "sans-serif,18" background "white"'
png = 'set terminal pngcairo size 2*wide,2*tall fontscale 2 linewidth 2 pointscale 2 font "DejaVu Sans,13"'
PAGE = (form eq 'svg' ? svg : png).'; set output out'

set encoding utf8
set datafile separator comma

# Okabe and Ito's colours can be told apart by colour-blind readers; a dash pattern for each line is
# the second cue, and a mark the third. Yellow is for fills only.
set linetype 1 lc rgb '#0072B2' lw 2 dt 1          pt 7 ps 0.7
set linetype 2 lc rgb '#D55E00' lw 2 dt (12,4)     pt 5 ps 0.7
set linetype 3 lc rgb '#009E73' lw 2 dt (3,3)      pt 9 ps 0.8
set linetype 4 lc rgb '#CC79A7' lw 2 dt (12,4,3,4) pt 13 ps 0.9
set linetype 5 lc rgb '#E69F00' lw 2 dt (20,4)     pt 11 ps 0.8
set linetype 6 lc rgb '#56B4E9' lw 2 dt (6,3)      pt 6 ps 0.7
set linetype 7 lc rgb '#F0E442' lw 2 dt 1          pt 4 ps 0.7
set linetype 8 lc rgb '#4D4D4D' lw 1.5 dt 1        pt 2 ps 0.7

AXES = "set border 3 lc rgb '#808080'; set tics nomirror out scale 1 textcolor rgb '#303030'; set grid y lc rgb '#dddddd' lw 0.7 dt 1"
@AXES
SIDE = "set label 99 side at screen 0.027,graph 0.5 center rotate textcolor rgb '#202020'"
set key above reverse Left samplen 2.5 width 1 textcolor rgb '#202020'
soft = '#5c5c5c'
powers = '10^{%L}'
