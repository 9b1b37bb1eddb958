n1 g71 g17 g40 g90 g54
n2 g0 x0 y0 z5
n3 g1 z-1 f300
n10 g1 x10 y0
n20 g3 x20 cr=6
n30 x=ic(5) rnd=2
trans x5
n40 x40
n900 g0 z5
n999 m30
