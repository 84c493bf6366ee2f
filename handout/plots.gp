# The handout's plots, from the tables in the folder where it is started (out/handout/work).
set terminal svg size 640,400 font "STIX,Georgia,serif,16" enhanced background "#ffffff"
figures = "../../../handout/figures/"
set grid lc rgb "#dddddd"
set border lc rgb "#444444"
set tics textcolor rgb "#222222"
set style line 1 lc rgb "#0072b2" lw 2.5 pt 7 ps 0.6
set style line 2 lc rgb "#d55e00" lw 2.5 pt 5 ps 0.6
set style line 3 lc rgb "#009e73" lw 2.5 pt 9 ps 0.6

set output figures."plot-point.svg"
set logscale xy
set format y "10^{%T}"
set xlabel "distance, in edges of the squares"
set ylabel "relative error of F"
plot "point.dat" using 1:2 with lines ls 2 title "centre to centre (calcAnalyticalFF)", \
     "" using 1:3 with lines ls 1 title "centre to the whole square"

set output figures."plot-orders.svg"
set xlabel "shots"
set ylabel "unshot share of the light's power"
set key bottom left
plot "orders.dat" using 1:4 with lines ls 3 title "drawn at random", \
     "" using 1:3 with lines ls 1 title "one after the other", \
     "" using 1:2 with lines ls 2 title "the brightest first"

set output figures."plot-sampling.svg"
set key top right
set xlabel "pixels of the hemicube, or rays"
set ylabel "relative error of F, root of the mean square"
set format x "10^{%T}"
plot "hemicube.dat" using 5:2 with linespoints ls 1 title "hemicube, sizes 16 to 512", \
     "hemisphere.dat" using 5:2 with linespoints ls 2 title "hemisphere, 256 to 16,384 rays"

set output figures."plot-light.svg"
set ylabel "relative error of the radiosities"
set xlabel "milliseconds for the form factors from one patch"
set format x "%g"
plot "hemicube.dat" using 4:6 with linespoints ls 1 title "hemicube, sizes 16 to 512", \
     "hemisphere.dat" using 4:6 with linespoints ls 2 title "hemisphere, 256 to 16,384 rays"

set output figures."plot-profile.svg"
unset logscale
set format x "%g"
set format y "%.2f"
set xlabel "pixel along a row of the picture, across the back wall"
set ylabel "radiance, green channel"
set key bottom center
plot "profile.dat" using 1:2 with lines ls 2 title "flat", "" using 1:3 with lines ls 1 title "smooth"
