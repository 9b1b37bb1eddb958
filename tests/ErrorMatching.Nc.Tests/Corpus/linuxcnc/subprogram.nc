o100 sub
N10 G1 X#1 Y#2 F100
o100 return [#1+1]
o100 endsub
G21 G17 G40 G90
G0 X0 Y0 Z5
G1 Z-1 F300
o100 call [5] [6]
N20 X#<_value>
M2
