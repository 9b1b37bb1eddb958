G21 G17 G40 G90
G0 X0 Y0 Z5
G1 Z-1 F300
o5 repeat [4]
N10 G91 X3
o6 if [#5 GT 2]
o5 break
o6 endif
o5 endrepeat
G90
G0 Z5
M30
