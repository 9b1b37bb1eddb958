o1 sub
N10 G0 X1
o1 call
o1 endsub
o1 call
M2
