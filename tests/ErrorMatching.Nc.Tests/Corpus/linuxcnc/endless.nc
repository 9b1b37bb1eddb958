G21
#1=1
o1 while [#1]
N10 G0 X#1
o1 endwhile
M2
