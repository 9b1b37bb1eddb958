namespace ErrorMatching.Nc.Tests;

/// <summary>Variables, branches and calls of Okuma programs, and their displacement. Expected places are computed by hand.</summary>
public sealed class OkumaFlowTests
{
    private const string Okuma = "okuma-osp";

    // Behind a sub, so that the main program ends first.
    private const string Subs = "\nM30\nOSUB\nG0 X=PA\nY5.\nRTS\nOSET\nPB=4\nVC7=8\nRTS\nOOPT\nIF [PA EQ EMPTY] NE\nX=PA\nNE Z9.\nRTS\n";

    [Theory]
    [InlineData("VC1=10\nX=VC1+5 Y=-VC1", "R15,-10,0")]
    [InlineData("V1=2\nX=V1*3-1", "R5,0,0")]
    [InlineData("XPOS=7\nX=[XPOS+[1-3]]*2", "R10,0,0")]
    [InlineData("VC3=1\nVC[VC3+1]=4\nX=VC2 Y=VC[2]", "R4,4,0")]
    [InlineData("X=12/4+2*3", "R9,0,0")]
    [InlineData("X=SIN[30]*10 Y=COS[60]*10 Z=SQRT[16]", "R5,5,4")]
    [InlineData("X=MOD[60,7] Y=ABS[-3] Z=ATAN[1]", "R4,3,45")]
    [InlineData("X=FIX[3] Y=#1FH", "R3,31,0")]
    [InlineData("X=10 Y= 2.5", "R10,2.5,0")]
    [InlineData("GOTO NB\nX1.\nNB X2.", "R2,0,0")]
    [InlineData("GOTO N5\nX1.\nN5 X2.", "R2,0,0")]
    [InlineData("VC1=0\nNLP VC1=VC1+1\nX=VC1\nIF [VC1 LT 3] NLP\nY1.", "R1,0,0 R2,0,0 R3,0,0 R3,1,0")]
    [InlineData("IF [[1 EQ 1] AND [2 GT 3]] NA\nX1.\nNA Y1.", "R1,0,0 R1,1,0")]
    [InlineData("IF [PQ EQ EMPTY] GOTO NA\nX1.\nNA Y1.", "R0,1,0")]
    [InlineData("PA=EMPTY\nIF [PA NE EMPTY] NA\nX1.\nNA Y1.", "R1,0,0 R1,1,0")]
    [InlineData("CALL OSUB PA=3\nX1." + Subs, "R3,0,0 R3,5,0 R1,5,0")]
    [InlineData("VC9=2\nCALL OSUB Q=VC9 PA=VC9*2\nX1." + Subs, "R4,0,0 R4,5,0 R4,5,0 R4,5,0 R1,5,0")]
    [InlineData("CALL OSUB Q2 PA=3\nX1." + Subs, "R3,0,0 R3,5,0 R3,5,0 R3,5,0 R1,5,0")]
    [InlineData("CALL OSET\nX=VC7" + Subs, "R8,0,0")]
    [InlineData("CALL OOPT PA=2\nCALL OOPT" + Subs, "R2,0,0 R2,0,9 R2,0,9")]
    [InlineData("MODIN OOPT PA=6\nM8\nX1.\nX2. Z0\nMODOUT\nX3." + Subs, "R1,0,0 R6,0,0 R6,0,9 R2,0,0 R6,0,0 R6,0,9 R3,0,9")]
    [InlineData("X1.\nRTS\nX2.", "R1,0,0")]
    [InlineData("X1.\nOTWO\nX2.", "R1,0,0")]
    [InlineData("X1.\n%\nX2.", "R1,0,0")]
    [InlineData("VDOUT[5]=1\nX1.", "R1,0,0")]
    [InlineData("NOEX X1.", "R1,0,0")]
    [InlineData("NA X1. (A COMMENT) Y2.", "R1,2,0")]
    public void Motions(string program, string moves) => Assert.Equal(moves, Moves.Of(Okuma, program));

    // What only the machine knows, and what sources do not say.
    [Theory]
    [InlineData("X=VC1", "R?,0,0")]
    [InlineData("X=VTOFD[1]+1", "R?,0,0")]
    [InlineData("X=XNEW", "R?,0,0")]
    [InlineData("X=FIX[2.5] Y=DROUND[1.] Z=ATAN2[1,2]", "R?,?,?")]
    [InlineData("X=MOD[5.5,2] Y=BIN[4]", "R?,?,0")]
    [InlineData("XA=XB\nX=XA", "R?,0,0")]
    [InlineData("VZOFX[1]=0\nX1.", "R1,?,?")]
    [InlineData("PB=1\nCALL OSET\nX=PB" + Subs, "R?,0,0")]
    [InlineData("PB=1\nCALL OSET\nPB=2\nX=PB" + Subs, "R2,0,0")]
    [InlineData("XA=5\nCALL OGET\nM30\nOGET\nX=XA\nRTS", "R?,0,0")]
    [InlineData("G15 H=VC1\nX1.", "R1,?,?")]
    [InlineData("PA=1\nCALL OSUB PA=2\nX=PA" + Subs, "R2,0,0 R2,5,0 R?,5,0")]
    [InlineData("BHC X1. Y2. I5. J0 K4\nX1.", "C?,?,? R1,?,?")]
    public void What_nobody_knows_stays_unknown(string program, string moves) => Assert.Equal(moves, Moves.Of(Okuma, program));

    [Theory]
    [InlineData("GOTO N100", "missing-label")]
    [InlineData("GOTO NA\nNA X1.\nNA X2.", "block-ambiguous")]
    [InlineData("GOTO 5", "bad-expression")]
    [InlineData("IF [VC1 EQ 1] N100", "unknown-condition")]
    [InlineData("IF [VDIN[1] EQ 1] N100", "unknown-condition")]
    [InlineData("IF [PX EQ 0] N100", "unknown-condition")]
    [InlineData("IF [0.1+0.2 EQ 0.3] N100", "unknown-condition")]
    [InlineData("IF [1 EQ 1 AND 2 EQ 2] N100", "bad-expression")]
    [InlineData("IF [NOT 1] N100", "bad-expression")]
    [InlineData("IF [1 EQ 1] X5", "bad-expression")]
    [InlineData("IF 1 EQ 1 N5", "bad-expression")]
    [InlineData("VC1=1/0", "bad-expression")]
    [InlineData("VC1=FUNC[3]", "bad-expression")]
    [InlineData("VC1=", "bad-expression")]
    [InlineData("VC1=5 X=VC1", "bad-expression")]
    [InlineData("CALL O100 PX=1", "missing-program")]
    [InlineData("CALL O100 Q0" + "\nM30\nO100\nRTS", "bad-expression")]
    [InlineData("CALL O100 VC1=5" + "\nM30\nO100\nRTS", "bad-expression")]
    [InlineData("CALL O100 Q=VC1" + "\nM30\nO100\nRTS", "unknown-condition")]
    [InlineData("CALL O100" + "\nM30\nO0100\nRTS", "missing-program")]
    [InlineData("CALL 100", "bad-expression")]
    [InlineData("G0 X1 CALL O100" + "\nM30\nO100\nRTS", "missing-program")]
    [InlineData("MODIN O100", "missing-program")]
    [InlineData("G101 X5", "missing-program")]
    [InlineData("G196", "missing-program")]
    public void What_is_not_followed_is_refused_at_its_block(string block, string code)
    {
        var refusal = Bench.Read("G90 G17 G40 G0 X0. Y0. Z0.\n" + block, NcDialects.Named(Okuma)).Refusal;
        Assert.Equal((code, 2), (refusal?.Code, refusal?.Place.Line));
    }

    [Theory]
    [InlineData("CALL OSUB PA=1")]
    [InlineData("MODIN OSUB PA=1")]
    [InlineData("RTS")]
    public void Calls_while_a_modal_call_is_active_are_refused(string block)
    {
        var refusal = Bench.Read("G90 G0 X0. Y0. Z0.\nMODIN OSUB PA=1\n" + block + Subs, NcDialects.Named(Okuma)).Refusal;
        Assert.Equal(("missing-program", 3), (refusal?.Code, refusal?.Place.Line));
    }

    [Fact]
    public void A_file_of_another_name_is_no_program_that_is_called()
    {
        var called = NcProgram.FromText("$OSUB.SUB%\nOSUB\nX=PA\nRTS\n%\n");
        var program = NcProgram.FromText("G90 G0 X0. Y0. Z0.\nCALL OSUB PA=3\n");
        var path = NcInterpreter.Run(program, NcDialects.Named(Okuma), n => n == "OSUB" ? called : null, CancellationToken.None);
        Assert.Equal("R3,0,0", Moves.Of(path, 1));
        var another = NcProgram.FromText("OTHER\nX5.\nRTS\n");
        var other = NcInterpreter.Run(program, NcDialects.Named(Okuma), _ => another, CancellationToken.None);
        Assert.Equal("missing-program", other.Refusal?.Code);
    }

    [Theory]
    [InlineData("G0 X0. Y=YPOS Z0.\nN1 G1 X=XPOS+10\nG0 Y50.", "G0 X0. Y=YPOS+0.5 Z0.\nN1 G1 X=XPOS+10\nG0 Y50.")]
    [InlineData("G0 X0. Y=[YPOS] Z0.\nN1 G1 X10.\nG0 Y50.", "G0 X0. Y=[YPOS]+0.5 Z0.\nN1 G1 X10.\nG0 Y50.")]
    [InlineData("G0 X0. Y=5 Z0.\nN1 G1 X10. Y=YPOS*1\nG0 Y50.", "G0 X0. Y=5.5 Z0.\nN1 G1 X10. Y=YPOS*1+0.5\nG0 Y50.")]
    [InlineData("NA G0 X0. Y5. Z0.\nN1 G1 X10. (A)\nG0 Y50.", "NA G0 X0. Y5.5 Z0.\nN1 G1 X10. (A)\nG0 Y50.")]
    public void Computed_words_get_another_term(string before, string after)
    {
        const string Head = "$A.MIN%\nO1\nG90 G17 G21 G40\nXPOS=0\nYPOS=5\n";
        Assert.Equal(Head + after + "\nM30\n%\n",
            Bench.Normal(Head + before + "\nM30\n%\n", 0.5, "N1", NcDialects.Named(Okuma)));
    }

    [Fact]
    public void A_block_whose_runs_differ_is_not_displaced()
    {
        const string Text = "G90 G17 G21 G40\nVC1=0\nNL VC1=VC1+1\nG0 X0. Y0. Z0.\nN1 G1 X=VC1*10 Y=10/VC1\nG0 Z5.\n"
            + "IF [VC1 LT 2] NL\nM30\n";
        Assert.Equal("runs-differ", Bench.RefusedNormal(Text, 0.5, "N1", NcDialects.Named(Okuma)).Code);
    }

    [Fact]
    public void The_marker_is_behind_the_name_of_the_program()
    {
        var marker = new Marker(new string('a', 64), new string('b', 64));
        var program = NcProgram.FromText("$A.MIN%\nOPART\nG0 X1.\n", NcSyntax.Okuma);
        var marked = NcProgram.Read(marker.InsertInto(program), NcSyntax.Okuma);
        Assert.Equal((2, marker), Assert.Single(Marker.Find(marked)));
        Assert.Equal("(" + marker.TextIn(NcSyntax.Okuma).Trim('(', ')') + ")", marked.TextOf(marked[2]));
    }
}
