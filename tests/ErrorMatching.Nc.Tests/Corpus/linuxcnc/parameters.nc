G21 G17 G40 G90
G0 X0 Y0 Z5
G1 Z-1 F300
#1=10 #2=[#1*2]
N10 G1 X#1 Y[#2/4]
N20 X[#1+#2] Y[SIN[30]*10]
#<width>=5
#<_shared>=7
N30 X#<width> Y#<_shared>
N40 X[ATAN[1]/[1]] Y[2**3 MOD 5]
G0 Z5
M30
