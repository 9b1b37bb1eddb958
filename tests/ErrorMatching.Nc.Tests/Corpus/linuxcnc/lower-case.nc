g21 g17 g40 g90
g0 x0 y0 z5
g1 z-1 f300
n10 g1 x10 y0 f500
n20 x20 y5
n30 g2 x30 y5 i5 j0
n40 g3 x40 y5 i5 j0
n50 g1 x50 y0
n60 x60
g0 z5
m30
