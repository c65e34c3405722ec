# Speed, chatter and overlap of a stack of ten, and overlap under a heavy load, by technique: a table.
tall = 780
@PAGE
array names[17] = ['contact_damped', 'basic', 'analytic', 'time_stepping', 'impulse', 'damped', 'timewarp_simple', 'timewarp_safer', 'timewarp_swept', 'timewarp_full', 'glued', 'penalty', 'faure', 'relaxation', 'settling', 'optimised', 'microcollisions']
array columns[6] = ['stack_m_s', 'chatter_m', 'overlap_m', 'mass10_m', 'mass100_m', 'mass1000_m']
array places[6] = [0.335, 0.445, 0.555, 0.695, 0.805, 0.915]
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [0:1]; set yrange [17.6:-3.6]
# White: below a micrometre; blue: below a tenth of a millimetre; orange: above it; dark: falls.
shown(v) = v != v ? '–' : v < 1e-6 ? '0' : v < 1e-3 ? '<0.001' : v < 10 ? sprintf('%.2g', v) : sprintf('%.0f', v)
shade(v) = v != v ? 0xF2C9A8 : v < 1e-3 ? 0xFFFFFF : v < 0.1 ? 0xEAF3FA : 0xFBEBDD
small = form eq 'svg' ? ',16' : ',11.5'
set label 1 'stack of ten' at 0.445,-2.7 center textcolor rgb '#202020'
set label 2 'overlap, heavier top' at 0.805,-2.7 center textcolor rgb '#202020'
set label 3 "speed\nmm/s" at 0.335,-1.5 center font small textcolor rgb soft
set label 4 "chatter\nmm" at 0.445,-1.5 center font small textcolor rgb soft
set label 5 "overlap\nmm" at 0.555,-1.5 center font small textcolor rgb soft
set label 6 "10 ×\nmm" at 0.695,-1.5 center font small textcolor rgb soft
set label 7 "100 ×\nmm" at 0.805,-1.5 center font small textcolor rgb soft
set label 8 "1000 ×\nmm" at 0.915,-1.5 center font small textcolor rgb soft
set label 9 '–: does not stand' at 0.02,17.1 left textcolor rgb soft
set for [k = 0:17] arrow k + 1 from 0.01,k - 0.5 to 0.975,k - 0.5 nohead lw 0.7 lc rgb '#cccccc'
plot for [c = 1:6] stem.'.csv' using (places[c]):'technique':(0.055):(0.47):(shade(1e3*column(columns[c]))) with boxxyerror fs solid 1.0 noborder lc rgb variable, \
  for [c = 1:6] '' using (places[c]):'technique':(shown(1e3*column(columns[c]))) with labels center font small textcolor rgb '#202020', \
  '' using (0.02):'technique':(names[int(column('technique')) + 1]) with labels left noenhanced font small textcolor rgb '#202020'
