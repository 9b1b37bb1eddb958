o<pocket> sub
N10 G1 X[#1] F100
o<pocket> endsub [3]
G21
o<pocket> call [1]
o<pocket> call [2]
M2
