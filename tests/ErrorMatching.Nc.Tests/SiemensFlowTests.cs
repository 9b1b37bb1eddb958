using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>Siemens 840D: which blocks run, and with which values. Expected traces are worked out by hand.</summary>
public sealed class SiemensFlowTests
{
    [Fact]
    public void Parameters_are_assigned_in_their_order()
    {
        var run = Runs("R1=5 R2=R1*2\nR[R1]=7\nN1 X=R5+R2\nM30", "N1=17 4");
        Assert.Equal("7", run.Number(5));
    }

    [Theory]
    [InlineData("GOTOF")]
    [InlineData("GOTO")]
    public void A_jump_forward_goes_to_its_label(string jump) =>
        Runs($"N1 X1\n{jump} ENDE\nN2 X2\nENDE: N3 X3\nM30", "N1 4 5");

    [Fact]
    public void A_conditional_jump_back_makes_a_loop() =>
        Runs("R1=0\nLOOP_1: R1=R1+1\nN10 X=R1\nIF R1<3 GOTOB LOOP_1\nM30", "N10=1 N10=2 N10=3 5");

    [Fact]
    public void A_jump_can_name_a_block_number_or_a_text() =>
        Runs("DEF STRING[10] ZIEL\nZIEL=\"ENDE\"\nGOTOF N30\nN20 X2\nN30 X3\nGOTOF ZIEL\nN40 X4\nENDE: M30", "N30 8");

    [Fact]
    public void If_else_endif_chooses() =>
        Runs("R1=1\nIF R1==1\nN1 X1\nIF R1==2\nN2 X2\nELSE\nN3 X3\nENDIF\nELSE\nN4 X4\nENDIF\nM30", "N1 N3 12");

    [Fact]
    public void While_for_loop_and_repeat_run() =>
        Runs(
            "DEF INT I\nFOR I=1 TO 2\nN1 X=I\nENDFOR\nWHILE I<5\nN2 X=I\nI=I+1\nENDWHILE\nREPEAT\nN3 X=I\nI=I-1\nUNTIL "
                + "I<4\nLOOP\nI=I+1\nIF I>4 GOTOF ENDE\nENDLOOP\nENDE: N4 X=I\nM30",
            "N1=1 N1=2 N2=3 N2=4 N3=5 N3=4 17=5 18");

    [Fact]
    public void A_section_is_repeated()
    {
        Runs("R1=0\nA1: R1=R1+1\nN1 X=R1\nREPEAT A1 P=2\nN2 X9\nM30", "N1=1 N1=2 N1=3 N2 6");
        Runs("R1=0\nA1: R1=R1+1\nN1 X=R1\nA2: N2 X2\nN3 X3\nREPEAT A1 A2 P=1\nN4 X4\nM30", "N1=1 4 N3 N1=2 4 N4 8");
        Runs("R1=0\nA1: X5\nN2 X2\nREPEATB A1 P=2\nN3 X3\nM30", "2 N2 2 2 N3 6");
        Runs("A1: X5\nN2 X2\nENDLABEL: X6\nN3 X3\nREPEAT A1\nM30", "1 N2 3 N3 1 N2 3 6");
    }

    [Theory]
    [InlineData(1, "3 4 5")]
    [InlineData(2, "4 5")]
    [InlineData(7, "5")]
    public void Case_jumps_by_value(int value, string trace) =>
        Runs(
            string.Create(
                CultureInfo.InvariantCulture,
                $"R1={value}\nCASE (R1) OF 1 GOTOF EINS 2 GOTOF ZWEI DEFAULT GOTOF ENDE\nEINS: X1\nZWEI: X2\nENDE: M30"),
            trace);

    [Fact]
    public void Subprograms_of_an_archive_are_called_by_name() =>
        Runs(
            "%_N_HAUPT_MPF\nN1 X1\nTASCHE P2\nL10\nCALL \"TASCHE\"\nM30\n%_N_TASCHE_SPF\nN5 X5\nM17\n%_N_L10_SPF\nN6 X6\nRET\n",
            "N1 N5 9 N5 9 N6 N5 9 6");

    [Fact]
    public void The_main_program_of_an_archive_runs_first() =>
        Runs("%_N_UP_SPF\nN5 X5\nM17\n%_N_HAUPT_MPF\nN1 X1\nUP\nM30\n", "N1 N5 3 7");

    [Fact]
    public void Arguments_go_to_the_parameters_of_a_procedure()
    {
        var run = Runs(
            "%_N_HAUPT_MPF\nDEF REAL ERG=1, A=100\nUP(2,1.6,ERG)\nN1 X=ERG\nN2 X=A\nM30\n%_N_UP_SPF\nPROC UP(REAL A, INT B, VAR REAL C, "
                + "REAL D=10) SAVE\nC=A+B+D\nA=0\nRET\n",
            "N1=14 N2=100 6");
        Assert.Equal("14", run.Named("ERG"));
    }

    [Fact]
    public void Arrays_hold_what_is_put_into_them() =>
        Runs(
            "DEF REAL F[2,3]=SET(1,2,3,4,5,6), G[4]\nN1 X=F[1,0]\nG[0]=SET(7,8)\nG[2]=REP(9)\nN2 X=G[1]\nN3 X=G[3]\nF[1,2]=F[0,1]*10\nN4 "
                + "X=F[1,2]\nM30",
            "N1=4 N2=8 N3=9 N4=20 9");

    [Fact]
    public void Variables_keep_to_their_type() =>
        Runs("DEF INT I=2.6\nDEF BOOL B\nB=5\nN1 X=I\nN2 X=B\nM30", "N1=3 N2=1 6");

    [Fact]
    public void Programs_come_from_the_library_and_words_of_the_language_do_not()
    {
        var settings = FlowRun.Library(("UP", "N5 X5\nM17"));
        Runs("STOPRE\nUP\nCYCLE81(1,,2)\nM30", "1 N5 2 3 4", settings);
    }

    [Theory]
    [InlineData("N5 IF R1==1 GOTOF AA", "unknown-condition", "N5")]
    [InlineData("N5 IF $AA_IW[X]>0\nENDIF", "unknown-condition", "N5")]
    [InlineData("N5 GOTOF AA\nM30", "missing-label", "N5")]
    [InlineData("AA:\nN5 GOTOF AA\nM30", "missing-label", "N5")]
    [InlineData("N5 GOTOB AA\nAA: M30", "missing-label", "N5")]
    [InlineData("AA: X1\nN5 GOTOB AA", "endless-loop", "N5")]
    [InlineData("LOOP\nX1\nN5 ENDLOOP", "endless-loop", "N5")]
    [InlineData("N5 ENDIF", "missing-label", "N5")]
    [InlineData("N5 L10", "missing-program", "N5")]
    [InlineData("EXTERN UP(REAL)\nN5 UP(1)", "missing-program", "N5")]
    [InlineData("N5 CALL \"UP\"", "missing-program", "N5")]
    [InlineData("N5 R1=1/0", "bad-expression", "N5")]
    [InlineData("N5 R1=(1+2", "bad-expression", "N5")]
    [InlineData("N5 DEF REAL A[0]", "bad-expression", "N5")]
    [InlineData("%_N_A_MPF\nBB(1)\nM30\n%_N_BB_SPF\nN5 X1\nM17", "bad-expression", "line 4")]
    [InlineData("%_N_AA_MPF\nBB\nM30\n%_N_BB_SPF\nN5 BB\nM17", "call-too-deep", "N5")]
    public void What_cannot_go_on_is_refused_with_its_block(string text, string code, string block)
    {
        var refusal = FlowRun.Of(NcSyntax.Siemens, text).Refusal;
        Assert.Equal((code, block), (refusal?.Code, refusal?.Place.Block));
    }

    [Fact]
    public void Behind_a_stop_that_the_machine_decides_on_the_program_goes_on()
    {
        var run = FlowRun.Of(NcSyntax.Siemens, "N1 X1\nIF $AC_MEA[1]==0\nMSG(\"missed\")\nSETAL(65000,\"missed\")\nM30\nENDIF\nN2 X2\nM30");
        Assert.Null(run.Refusal);
        Assert.Equal("N1 N2 8", run.Trace);
        Assert.Equal("conditional-stop", Assert.Single(run.Flow.Notes).Code);
    }

    [Theory]
    [InlineData("IF $AC_MEA[1]==0\nSETAL(65000)\nENDIF")]
    [InlineData("IF $AC_MEA[1]==0\nG0 X5\nM30\nENDIF")]
    [InlineData("IF $AC_MEA[1]==0\nM30\nELSE\nN3 X3\nENDIF")]
    [InlineData("IF $AC_MEA[1]==0\nR1=2\nENDIF")]
    public void Other_branches_that_the_machine_decides_on_are_refused(string branch) =>
        Assert.Equal(NcRefusalCodes.UnknownCondition, FlowRun.Of(NcSyntax.Siemens, branch + "\nN2 X2\nM30").Refusal?.Code);

    private static FlowRun Runs(string text, string trace, FlowSettings? settings = null)
    {
        var run = FlowRun.Of(NcSyntax.Siemens, text, settings);
        Assert.Null(run.Refusal);
        Assert.Equal(trace, run.Trace);
        return run;
    }
}
