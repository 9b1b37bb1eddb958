G21 G17 G40 G90
G0 X0 Y0 Z5
G1 Z-1 F300
(a comment)
N10 X5 (inside) Y5 (end)
; to the end ( of the line )
N20 X10 ; G1 X99
(MSG, hello)
(DEBUG, #1)
N30 (un)X(believable)15
G0 Z5
M30
