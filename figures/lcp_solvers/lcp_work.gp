# Multiplications of contact solvers against the number of contacts, at rest and noisy.
tall = 980
@PAGE
set multiplot
set lmargin at screen 0.18; set rmargin at screen 0.95
set logscale xy
set xrange [14:1200]
set xtics (16, 64, 256, 1024)
set yrange [1e3:1e10]
set format y powers
set ytics 1e3,10
side = 'multiplications'; @SIDE
solvers = 'augmented_lagrangian baraff least_constraint gauss_seidel lemke baraff_as_printed'
names = '"method of multipliers" "Baraff, factors kept" "least constraint" "Gauss-Seidel" "Lemke" "Baraff, as printed"'
# Colours of the solvers in the order of the table, by which failures name them.
colours = '2 5 4 3 1 6 8'
do for [panel = 1:2] {
  numbers = panel == 1 ? stem.'.csv' : stem.'_noisy.csv'
  if (panel == 1) {
    set tmargin at screen 0.86; set bmargin at screen 0.50
    set key at screen 0.56,0.99 center top vertical maxrows 4 width -1
    set format x ''
    unset xlabel
  } else {
    set tmargin at screen 0.46; set bmargin at screen 0.09
    unset key
    set format x '%g'
    set xlabel 'contacts' offset 0,0.3
  }
  set label 1 (panel == 1 ? 'at rest' : 'with random velocities') at graph 0.03,0.93 textcolor rgb soft
  plot numbers using 'contacts':'dense' with lines lt 8 title 'one factorisation', \
    for [k = 1:6] '' using 'contacts':word(solvers, k) with linespoints lt k title word(names, k), \
    stem.'_failed.csv' using 'contacts':(column('noisy') == panel - 1 ? column('multiplications') : NaN): \
      (int(word(colours, int(column('solver'))))) with points pt 2 ps 1.6 lw 2.5 lc variable title 'no answer'
}
