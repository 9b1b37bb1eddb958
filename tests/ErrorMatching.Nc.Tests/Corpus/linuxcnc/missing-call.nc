G21 G0 X1
o<nowhere> call [1]
N10 G1 X2 F100
M2
