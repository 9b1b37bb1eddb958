namespace ErrorMatching.Nc.Tests;

/// <summary>Fanuc custom macro: which blocks run, and with which values. Expected traces are worked out by hand.</summary>
public sealed class MacroFlowTests
{
    [Fact]
    public void If_goto_leaves_blocks_out() =>
        Runs("N1 G0\n#1=5\nIF[#1GT3]GOTO4\nN2 G1\nN3 G1\nN4 X#1\nM30\nN5 G1", "N1 N4=5 7");

    [Fact]
    public void A_false_condition_goes_on_below() =>
        Runs("#1=2\nIF [#1 GT 3] GOTO 4\nN2 X#1\nN4 X[#1+1]\nM30", "N2=2 N4=3 5");

    [Fact]
    public void If_then_assigns() =>
        Runs("#1=2\nIF[#1EQ2]THEN#2=7\nIF[#1EQ3]THEN #2=8\nN1 X#2\nM30", "N1=7 5");

    [Fact]
    public void A_loop_by_goto_counts() =>
        Runs("#1=0\nN1 X#1\n#1=#1+1\nIF[#1LT3]GOTO1\nM30", "N1=0 N1=1 N1=2 5");

    [Fact]
    public void While_do_end_runs_while_it_holds() =>
        Runs("#1=1\nWHILE[#1LE3]DO1\nN1 X#1\n#1=#1+1\nEND1\nN2 X#1\nM30", "N1=1 N1=2 N1=3 N2=4 7");

    [Fact]
    public void Loops_stand_in_one_another() =>
        Runs(
            "#1=1\nWHILE[#1LE2]DO1\n#2=1\nWHILE[#2LE2]DO2\nN1 X[#1*10+#2]\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30",
            "N1=11 N1=12 N1=21 N1=22 10");

    [Fact]
    public void One_number_serves_two_loops_in_turn() =>
        Runs("#1=0\nWHILE[#1LT1]DO1\nN1 X1\n#1=#1+1\nEND1\nWHILE[#1LT3]DO1\nN2 X2\n#1=#1+1\nEND1\nM30", "N1 N2 N2 10");

    [Fact]
    public void A_loop_without_condition_is_left_by_a_jump() =>
        Runs("#1=0\nDO2\nN1 X#1\n#1=#1+1\nIF[#1EQ2]GOTO9\nEND2\nN9 M30", "N1=0 N1=1 N9");

    [Fact]
    public void A_jump_target_can_be_computed_and_stand_above() =>
        Runs("#1=10\nGOTO[#1+20]\nN10 X1\nM30\nN30 X3\nGOTO#1", "N30 N10 4");

    [Fact]
    public void A_subprogram_is_executed_where_it_is_called() =>
        Runs("O1\nN1 X1\nM98 P1002\nN2 X2\nM30\nO1002\nN11 X11\nM99\n", "N1 3 N11 8 N2 5");

    [Theory]
    [InlineData("M98 P1002 L3")]
    [InlineData("M98 P31002")]
    public void A_subprogram_is_repeated(string call) =>
        Runs($"O1\n{call}\nN2 X2\nM30\nO1002\nN11 X11\nM99\n", "2 N11 7 N11 7 N11 7 N2 4");

    [Fact]
    public void Subprograms_share_the_caller_s_local_variables() =>
        Runs("O1\n#1=5\nM98 P2\nN1 X#1\nM30\nO2\n#1=#1+1\nM99\n", "3 8 N1=6 5");

    [Fact]
    public void The_words_of_a_calling_block_come_first() =>
        Runs("O1\n#1=1\nN1 X#1 M98 P2\nM30\nO2\nN2 X2\nM99\n", "N1=1 N2 7 4");

    [Fact]
    public void A_macro_has_local_variables_of_its_own()
    {
        var run = Runs(
            "O1\n#1=5\n#100=1\nG65 P2 A7.5 B#1 X[#1*2]\nN1 X#1\nM30\nO2\nN2 X[#1+#2+#24]\n#1=99\n#100=#3\nM99\n", "4=10 N2=22.5 11 N1=5 6");
        Assert.Equal("vacant", run.Number(100));
    }

    [Fact]
    public void Each_letter_has_its_local_variable()
    {
        const string Letters = "ABCIJKDEFHMQRSTUVWXYZ";
        int[] locals = [1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];
        var call = string.Concat(Letters.Select((l, i) => FormattableString.Invariant($"{l}{i + 1}.")));
        var copies = string.Concat(locals.Select(l => FormattableString.Invariant($"#{l + 500}=#{l}\n")));
        var run = FlowRun.Of(NcSyntax.Iso, $"O1\nG65 P2 {call}\nM30\nO2\n{copies}M99\n");
        Assert.Null(run.Refusal);
        Assert.All(locals.Select((l, i) => (l, i)), p => Assert.Equal(FormattableString.Invariant($"{p.i + 1}"), run.Number(p.l + 500)));
    }

    [Fact]
    public void Further_centers_are_the_second_kind_of_arguments()
    {
        // B-64604EN: A1. B2. I-3. I4. D5. gives #1=1, #2=2, #4=-3, #7=5 (I4. goes to #7 first, then D5.).
        var run = FlowRun.Of(
            NcSyntax.Iso, "O1\nG65 P1000 A1. B2. I-3. I4. D5. J8.\nM30\nO1000\n#501=#1\n#502=#2\n#504=#4\n#507=#7\n#508=#8\nM99\n");
        Assert.Equal(["1", "2", "-3", "5", "8"], new[] { 501, 502, 504, 507, 508 }.Select(run.Number));
    }

    [Fact]
    public void A_repeated_macro_gets_its_arguments_each_time() =>
        Runs("O1\nG65 P2 L2 A1\nM30\nO2\n#1=#1+1\nN2 X#1\nM99\n", "2 N2=2 7 N2=2 7 3");

    [Fact]
    public void A_modal_macro_is_called_behind_each_motion() =>
        Runs("O1\nG66 P2 A5\nN1 X1\nN2 F100\nN3 X2\nG67\nN4 X3\nM30\nO2\nN9 Z#1\nM99\n", "2 N1 N9 11 N2 N3 N9 11 6 N4 8");

    [Fact]
    public void A_return_can_name_a_block_of_the_caller() =>
        Runs("O1\nM98 P2\nN1 X1\nN5 X5\nM30\nO2\nM99 P5\n", "2 7 N5 5");

    [Fact]
    public void The_end_of_a_main_program_by_M99_is_read_once()
    {
        var run = Runs("N1 X1\nM99\n", "N1 2");
        Assert.Equal("endless-program", Assert.Single(run.Flow.Notes).Code);
    }

    [Fact]
    public void The_next_program_of_the_file_ends_the_first() =>
        Runs("%\nO1\nN1 X1\nO2\nN2 X2\nM99\n%", "N1");

    [Fact]
    public void Programs_come_from_the_library_with_subprograms_of_their_own()
    {
        var library = FlowRun.Library(("O0100", "%\nO0100\nN50 X50\nM98 P200\nM99\nO0200\nN60 X60\nM99\n%\n"));
        Runs("O1\nM98 P100\nN1 X1\nM30\n", "2 N50 4 N60 8 5 N1 4", library);
    }

    [Fact]
    public void An_alarm_ends_the_program()
    {
        var run = Runs("#1=1\nIF[#1EQ0]GOTO5\n#3000=12(WRONG PART)\nN5 X1\nM30", "");
        Assert.Equal("program-alarm", Assert.Single(run.Flow.Notes).Code);
    }

    // A lock: nothing decides about it, so whoever reads on sees what the program does once it is taken out.
    [Theory]
    [InlineData("O1\nM0\n#3000=1(NO TOOL CALL)\nN1 X1\nM30", "2 N1 5", 2)]
    [InlineData("#3000=1\n#3000=2\nN1 X1\nM30", "N1 4", 0)]
    [InlineData("IF[1EQ2]GOTO9\n#3000=1\nN1 X1\nN9 M30", "", 1)]
    [InlineData("#100=1\n#3000=1\nN1 X1\nM30", "", 1)]
    [InlineData("N1 X1\n#3000=1\nN2 X2\nM30", "N1", 1)]
    [InlineData("GOTO5\nN5 #3000=1\nN1 X1\nM30", "", 1)]
    [InlineData("M98 P2\nN1 X1\nM30\nO2\n#3000=1\nM99", "1", 4)]
    public void An_alarm_that_nothing_leads_to_is_read_past(string text, string executed, int block)
    {
        var run = Runs(text, executed);
        var note = run.Flow.Notes[0];
        Assert.Equal(("program-alarm", block), (note.Code, note.Block));
    }

    [Fact]
    public void Behind_an_alarm_that_the_machine_decides_on_the_program_goes_on()
    {
        var run = Runs("N1 X1\nIF[#5061LT0.1]THEN #3000=1(NOT TOUCHED)\nN2 X2\nIF [#5061 LT 0.2] THEN #3000=2\nN3 X3\nM30", "N1 N2 N3 6");
        Assert.Equal("conditional-stop", Assert.Single(run.Flow.Notes).Code);
        Assert.Null(run.Refusal);
    }

    [Fact]
    public void An_assignment_that_the_machine_decides_on_is_still_refused() =>
        Assert.Equal(NcRefusalCodes.UnknownCondition, FlowRun.Of(NcSyntax.Iso, "IF[#5061LT0.1]THEN #300=1\nN2 X2\nM30").Refusal?.Code);

    [Fact]
    public void A_vacant_coordinate_is_as_if_not_written()
    {
        var run = Runs("#1=#0\nN1 X#1\nM30", "N1=vacant 3");
        Assert.Equal("vacant", run.Number(1));
    }

    [Theory]
    [InlineData("IF[#500EQ0]GOTO1\nN1 M30", "unknown-condition", "line 1")]
    [InlineData("N5 WHILE[#5041GT0]DO1\nEND1", "unknown-condition", "N5")]
    [InlineData("N5 GOTO#500", "unknown-condition", "N5")]
    [InlineData("N5 M98P#500", "unknown-condition", "N5")]
    [InlineData("N5 M#500", "unknown-condition", "N5")]
    [InlineData("N5 GOTO7\nN8", "missing-label", "N5")]
    [InlineData("N5 #1=1\nN6 WHILE[#1LT5]DO1\nM30", "missing-label", "N6")]
    [InlineData("N5 END1", "missing-label", "N5")]
    [InlineData("N5 #1=1/0", "bad-expression", "N5")]
    [InlineData("N5 #1 5", "bad-expression", "N5")]
    [InlineData("N5 IF[1EQ1]", "bad-expression", "N5")]
    [InlineData("N5 M98", "bad-expression", "N5")]
    [InlineData("N5 #34=1", "bad-expression", "N5")]
    [InlineData("N5 M98P77", "missing-program", "N5")]
    [InlineData("N5 G65P9000A1", "missing-program", "N5")]
    [InlineData("N5 G66P9000A1", "missing-program", "N5")]
    [InlineData("N5 GOTO5", "endless-loop", "N5")]
    [InlineData("#1=1\nN5 X1\nIF[#1EQ1]GOTO5", "endless-loop", "line 3")]
    [InlineData("#1=1\nWHILE[#1EQ1]DO1\nN6 END1", "endless-loop", "N6")]
    [InlineData("O1\nM98P2\nO2\nN7 M98P2\nM99", "call-too-deep", "N7")]
    public void What_cannot_go_on_is_refused_with_its_block(string text, string code, string block)
    {
        var refusal = FlowRun.Of(NcSyntax.Iso, text).Refusal;
        Assert.Equal((code, block), (refusal?.Code, refusal?.Place.Block));
    }

    [Fact]
    public void A_missing_program_is_named() =>
        Assert.Contains("O0077", FlowRun.Of(NcSyntax.Iso, "M98P77").Refusal!.Message, StringComparison.Ordinal);

    [Fact]
    public void A_bad_expression_has_its_column() =>
        Assert.Contains("column 9: division by zero", FlowRun.Of(NcSyntax.Iso, "N10 #1=5/0").Refusal!.Message, StringComparison.Ordinal);

    private static FlowRun Runs(string text, string trace, FlowSettings? settings = null)
    {
        var run = FlowRun.Of(NcSyntax.Iso, text, settings);
        Assert.Null(run.Refusal);
        Assert.Equal(trace, run.Trace);
        return run;
    }
}
