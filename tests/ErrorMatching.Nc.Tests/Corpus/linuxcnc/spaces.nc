g 21 g 9 0
g0 x 0 y 0 z 5
n10 g 1 x 1 . 5 y - 2 f 1 0 0
n20 x 1 0 y 1 2.5
m 2
