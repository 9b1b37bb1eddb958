namespace ErrorMatching.Nc.Tests;

/// <summary>Q parameters, labels and calls of Klartext.</summary>
public sealed class KlartextFlowTests
{
    private const string Origin = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 R0 FMAX\n";

    // The first two are the manual's own (iTNC 530, rules for formulas).
    [Theory]
    [InlineData("5 * 3 + 2 * 10", 35)]
    [InlineData("SQ 10 - 3^3", 73)]
    [InlineData("(1 + 2) * (3 + 4)", 21)]
    [InlineData("SIN30", 0.5)]
    [InlineData("COS 60 * 4", 2)]
    [InlineData("ATAN 1", 45)]
    [InlineData("ASIN 0.5 + ACOS 0.5", 90)]
    [InlineData("SQRT(9 + 16)", 5)]
    [InlineData("400 % 360", 40)]
    [InlineData("PI", 3.1416)]
    [InlineData("LN EXP 2", 2)]
    [InlineData("LOG 1000", 3)]
    [InlineData("NEG 4 + INT 5.7 + ABS -3", 4)]
    [InlineData("FRAC 5.25", 0.25)]
    [InlineData("SGN 5", 1)]
    [InlineData("+Q5 - -Q5", 6)]
    [InlineData("2 ^ 3", 8)]
    [InlineData("10 / 4 / 5", 0.5)]
    public void A_formula_has_this_value(string formula, double value)
    {
        var path = Read(Origin + $"FN 0: Q5 = +3\nQ1 = {formula}\nL X+Q1 FMAX\n");
        Assert.Null(path.Refusal);
        Assert.Equal(value, Math.Round(path.Motions[1].End.X, 4));
    }

    [Theory]
    [InlineData("SGN -5")]
    [InlineData("SIN 30^2")]
    [InlineData("-3^2")]
    [InlineData("2^3^2")]
    [InlineData("-7 % 3")]
    [InlineData("Q77")]
    [InlineData("Q108 + 1")]
    public void Where_controls_or_manuals_differ_the_value_is_unknown(string formula) =>
        Assert.Equal("R?,0,0", Moves.Of(Read(Origin + $"Q1 = {formula}\nL X+Q1 FMAX\n"), 1));

    [Theory]
    [InlineData("Q1 = 1 +", 9)]
    [InlineData("Q1 = (1", 8)]
    [InlineData("Q1 = 1,5", 7)]
    [InlineData("Q1 = SQRT -1", 13)]
    [InlineData("Q1 = 1 / 0", 11)]
    [InlineData("FN 1: Q1 = +3 - +2", 15)]
    [InlineData("FN 9: IF +Q5 EQU +3", 20)]
    [InlineData("CALL LBL 5 REP", 15)]
    public void What_is_wrong_is_refused_with_line_and_column(string statement, int column)
    {
        var refusal = Read(Origin + "FN 0: Q5 = +3\n" + statement + "\n").Refusal!;
        Assert.Equal(("bad-expression", 4, column), (refusal.Code, refusal.Place.Line, refusal.Place.Column));
    }

    [Theory]
    [InlineData("FN 0: Q1 = -5", -5)]
    [InlineData("FN 1: Q1 = -Q5 + -5", -8)]
    [InlineData("FN 2: Q1 = +10 - +Q5", 7)]
    [InlineData("FN 3: Q1 = +3 * +Q5", 9)]
    [InlineData("FN 4: Q1 = +8 DIV +2", 4)]
    [InlineData("FN 5: Q1 = SQRT 4", 2)]
    [InlineData("FN 6: Q1 = SIN-30", -0.5)]
    [InlineData("FN 7: Q1 = COS +60", 0.5)]
    [InlineData("FN 8: Q1 = +3 LEN +4", 5)]
    [InlineData("FN0:Q1=7", 7)]
    public void A_function_has_this_value(string function, double value) =>
        Assert.Equal(value, Math.Round(Read(Origin + $"FN 0: Q5 = +3\n{function}\nL X+Q1 FMAX\n").Motions[1].End.X, 6));

    [Theory]
    [InlineData("FN 9: IF +Q1 EQU +3 GOTO LBL 5", true)]
    [InlineData("FN 9: IF +Q1 EQU +4 GOTO LBL 5", false)]
    [InlineData("FN 10: IF +Q1 NE +4 GOTO LBL 5", true)]
    [InlineData("FN 11: IF +Q1 GT +2 GOTO LBL 5", true)]
    [InlineData("FN 11: IF +Q1 GT +3 GOTO LBL \"B\"", false)]
    [InlineData("FN 12: IF +Q1 LT +4 GOTO LBL \"B\"", true)]
    public void A_jump_goes_where_its_condition_says(string jump, bool goes) => Assert.Equal(
        goes ? "R9,0,0" : "R1,0,0 R9,0,0",
        Moves.Of(Read(Origin + $"FN 0: Q1 = +3\n{jump}\nL X+1 FMAX\nLBL 5\nLBL \"B\"\nL X+9 FMAX\n"), 1));

    [Fact]
    public void A_repeat_runs_the_section_so_many_times_more() => Assert.Equal(
        "L1,0,0 L2,0,0 L3,0,0 R0,0,0",
        Moves.Of(Read(Origin + "5 LBL 1\n6 L IX+1 F100\n7 CALL LBL 1 REP 2/2\n8 L X+0 FMAX\n"), 1));

    [Fact]
    public void Repeats_nest() => Assert.Equal(
        "L1,0,0 L2,0,0 L2,1,0 L3,1,0 L4,1,0 L4,2,0",
        Moves.Of(Read(Origin + "LBL 1\nLBL 2\nL IX+1 F100\nCALL LBL 2 REP 1\nL IY+1\nCALL LBL 1 REP1\nM30\n"), 1));

    [Fact]
    public void A_label_is_called_up_to_label_zero() => Assert.Equal(
        "L0,1,0 L0,2,0 L5,2,0",
        Moves.Of(Read(Origin + "CALL LBL 7\nCALL LBL \"7\"\nL X+5 F100\nM30\nLBL 7\nL IY+1 F100\nLBL 0\nEND PGM A MM\n"), 1));

    [Fact]
    public void A_program_is_called_with_common_and_own_parameters()
    {
        var path = NcInterpreter.Run(
            NcProgram.FromText(Origin + "Q1 = 2\nQL1 = 7\nCALL PGM TOOLS.H\nL X+Q1 Y+QL1 FMAX\n", NcSyntax.Klartext),
            NcDialects.HeidenhainKlartext,
            name => name == "TOOLS"
                ? NcProgram.FromText("0 BEGIN PGM T MM\n1 Q1 = Q1 + 1\n2 QL1 = 9\n3 L Z+Q1 FMAX\n4 END PGM T MM\n", NcSyntax.Klartext)
                : null,
            CancellationToken.None);
        Assert.Null(path.Refusal);
        Assert.Equal("R0,0,3 R3,7,3", Moves.Of(path, 1));
    }

    [Fact]
    public void A_called_program_in_another_unit_is_refused() => Assert.Equal("missing-program", NcInterpreter.Run(
        NcProgram.FromText(Origin + "CALL PGM T\n", NcSyntax.Klartext),
        NcDialects.HeidenhainKlartext,
        _ => NcProgram.FromText("\n; T\n0 BEGIN PGM T INCH\n1 L X+1\n", NcSyntax.Klartext),
        CancellationToken.None).Refusal!.Code);

    [Theory]
    [InlineData("CALL LBL 7", "missing-label")]
    [InlineData("CALL LBL 7 REP 2", "missing-label")]
    [InlineData("FN 0: Q1 = +1\nFN 9: IF +Q1 EQU +1 GOTO LBL 7", "missing-label")]
    [InlineData("FN 9: IF +Q9 EQU +1 GOTO LBL 5", "unknown-condition")]
    [InlineData("Q1 = 0.1 + 0.2\nFN 9: IF +Q1 EQU +0.3 GOTO LBL 5", "unknown-condition")]
    [InlineData("CALL LBL 5 REP Q9", "unknown-condition")]
    [InlineData("CALL PGM OTHER", "missing-program")]
    [InlineData("CALL PGM TNC:\\DIR\\OTHER.H", "missing-program")]
    [InlineData("SEL PGM \"A\"", "missing-program")]
    [InlineData("LBL 9\nFN 9: IF +0 EQU +0 GOTO LBL 9", "endless-loop")]
    [InlineData("LBL 9\nCALL LBL 9", "call-too-deep")]
    [InlineData("FN 14: ERROR = 300", "bad-expression")]
    [InlineData("FN 40: Q1 = +3", "bad-expression")]
    [InlineData("L X+1 M89", "missing-program")]
    public void What_cannot_be_followed_is_refused(string statements, string code)
    {
        var refusal = Read(Origin + "LBL 5\n" + statements + "\nL X+1 FMAX\n").Refusal!;
        Assert.Equal((code, 4 + statements.Count(c => c == '\n')), (refusal.Code, refusal.Place.Line));
    }

    [Fact]
    public void What_only_the_machine_knows_is_unknown() => Assert.Equal(
        "R?,0,0 R?,1,0",
        Moves.Of(Read(Origin + "FN 0: Q1 = +1\nFN 18: SYSREAD Q1 = ID210 NR4 IDX3\nL X+Q1 FMAX\nL Y+1 FMAX\n"), 1));

    private static NcPath Read(string text) => Bench.Read(text, NcDialects.HeidenhainKlartext);
}
