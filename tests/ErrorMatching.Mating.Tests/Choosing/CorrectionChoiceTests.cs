using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>By what a correction is made: what keeps an offset from being chosen, and what the control is told.</summary>
public sealed class CorrectionChoiceTests
{
    private const string MayMove = ", \"otherCuts\": \"may-move\"";

    private const string All = "\"tool-wear\", \"work-offset\", \"blocks\"";

    // One line of a contour under cutter compensation, with a way in and a way out.
    private const string Line =
        "%\nO1000\nN10 G21 G90 G17 G54\nN20 G0 X-20. Y-10.\nN30 G1 G41 D7 X0. Y0. F300\nN50 X50.\nN80 G40 X70. Y-10.\nN90 M30\n%\n";

    // The same contour with a side that no feature is on.
    private const string Corner = "%\nO1000\nN10 G21 G90 G17 G54\nN20 G0 X-20. Y-10.\nN30 G1 G41 D7 X0. Y0. F300\nN50 X50.\n"
        + "N60 X50. Y-30.\nN70 X20.\nN75 X10. Y-25.\nN80 G40 X0. Y-40.\nN90 M30\n%\n";

    [Fact]
    public void A_line_that_should_move_is_moved_by_the_radius_of_its_tool()
    {
        var match = Case(All).Match();
        Assert.Equal(
            (CorrectionKind.ToolWear, new(7, 0, Toward, null), null),
            (match.Correction!.Kind, match.Correction.Radius, match.Rewrite));
        Assert.True(match.Program.Span.SequenceEqual(Encoding.Latin1.GetBytes(Line)));
        Assert.All(match.Prediction.Features[0].Points, p => Assert.InRange(Math.Abs(p.AfterMm), 0, 0.0006));
        Assert.All(match.Prediction.Features[0].Points, p => Assert.InRange(Math.Abs(p.BeforeMm), 0.0199, 0.0201));
    }

    [Fact]
    public void The_control_is_told_in_its_own_words()
    {
        var text = Encoding.ASCII.GetString(Case(All).Match().Correction!.Program!);
        Assert.Contains("G90 G10 L13 P7 R[#501+[0.02]]", text, StringComparison.Ordinal);

        // The work offset is not needed, so what an earlier piece needed is taken out of it.
        Assert.Contains("G90 G10 L2 P1 X[#504+[0.0]] Y[#505+[0.0]]", text, StringComparison.Ordinal);
        Assert.StartsWith("%\nO9001(", text, StringComparison.Ordinal);
        Assert.DoesNotContain("{", text, StringComparison.Ordinal);
        Assert.DoesNotContain("?", text, StringComparison.Ordinal);
        Assert.DoesNotContain("LACKS", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_the_radius_it_is_the_work_offset() =>
        Assert.Equal(
            (CorrectionKind.WorkOffset, new(0, UpMm, 0)),
            (Case("\"work-offset\"").Match().Correction!.Kind, Case("\"work-offset\"").Match().Correction!.Work!.Total));

    [Theory]
    [InlineData("D7 ", "", "the program does not name the radius offset by D")]
    [InlineData("G41 D7 ", "", "cut without cutter compensation")]
    public void The_radius_is_left_alone_where_the_program_does_not_use_it(string from, string to, string reason)
    {
        var match = (Case(All) with { Program = Line.Replace(from, to, StringComparison.Ordinal), ToolDiameterMm = 6 });
        match = from.StartsWith("G41", StringComparison.Ordinal)
            ? match with { Theoretical = "1 10 -3; 2 40 -3", Part = FormattableString.Invariant($"1 10 {-3 + Up}; 2 40 {-3 + Up}") }
            : match;
        var choice = match.Match().Correction!;
        Assert.Equal(CorrectionKind.WorkOffset, choice.Kind);
        Assert.Contains(reason, Assert.Single(choice.Refused).Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void A_program_in_inches_is_corrected_by_blocks()
    {
        var inches = Line.Replace("G21", "G20", StringComparison.Ordinal).Replace("X50.", "X2.", StringComparison.Ordinal);
        var choice = (Case(All) with { Program = inches }).Match().Correction!;
        Assert.Equal((CorrectionKind.Blocks, null), (choice.Kind, choice.Program));
        Assert.All(choice.Refused, r => Assert.Contains("inches", r.Reason, StringComparison.Ordinal));
    }

    [Fact]
    public void A_cut_that_belongs_to_no_feature_keeps_offsets_from_being_used()
    {
        var stays = (Case(All) with { Program = Corner }).Match().Correction!;
        Assert.Equal(CorrectionKind.Blocks, stays.Kind);
        Assert.Equal([CorrectionKind.ToolWear, CorrectionKind.WorkOffset], stays.Refused.Select(r => r.Kind));
        Assert.All(stays.Refused, r => Assert.StartsWith("N60 belongs to no feature", r.Reason, StringComparison.Ordinal));
        var moves = Case(All, MayMove) with { Program = Corner };
        Assert.Equal(CorrectionKind.ToolWear, moves.Match().Correction!.Kind);
    }

    [Fact]
    public void A_tilt_is_nothing_for_an_offset_that_cannot_turn()
    {
        var tilted = Case(All) with { Part = "1 10 0.02; 2 40 0.03" };
        var choice = tilted.Match().Correction!;
        Assert.Equal(CorrectionKind.Blocks, choice.Kind);
        // Half of 10 um, less what the words of the blocks are rounded by.
        Assert.Matches("up to 0.00(4[6-9]|50) mm from where blocks bring it", choice.Refused[0].Reason);
        Assert.Contains("the control cannot rotate it", choice.Refused[1].Reason, StringComparison.Ordinal);
        var refusal = (tilted with { More = Correction("\"tool-wear\"") }).Refusal();
        Assert.Equal("offset-insufficient", refusal.Code);
        Assert.Matches("up to 0.00(4[6-9]|50) mm", refusal.Message);
    }

    [Fact]
    public void A_control_that_can_turn_turns()
    {
        var choice = (Case(All) with { Part = "1 10 0.02; 2 40 0.03", Dialect = "linuxcnc" }).Match().Correction!;
        Assert.Equal(CorrectionKind.WorkOffset, choice.Kind);

        // 10 um over 30 mm.
        Assert.InRange((double)choice.Work!.Total.RotationDegrees, (0.01 / 30 * 180 / Math.PI) - 2e-4, (0.01 / 30 * 180 / Math.PI) + 2e-4);
    }

    // The turn is 0.0191 degrees.
    [Theory]
    [InlineData(", \"stepDegrees\": 0.0195", CorrectionKind.WorkOffset)]
    [InlineData(", \"stepDegrees\": 0.0185", CorrectionKind.Blocks)]
    [InlineData(", \"totalDegrees\": 0.0195", CorrectionKind.WorkOffset)]
    [InlineData(", \"totalDegrees\": 0.0185", CorrectionKind.Blocks)]
    public void Limits_hold_for_the_turn_and_the_sum_of_turns(string limit, CorrectionKind kind) =>
        Assert.Equal(
            kind, (Case(All, limit) with { Part = "1 10 0.02; 2 40 0.03", Dialect = "linuxcnc" }).Match().Correction!.Kind);

    // The line rises by 8.5 and by 9.5 um, which a gauge of 3 um hardly tells: what is expected of the radius is 4 and 10 % above blocks
    // (rms), at its worst place 6 and more than 10 %.
    [Theory]
    [InlineData(0.0685, CorrectionKind.ToolWear)]
    [InlineData(0.0695, CorrectionKind.Blocks)]
    public void A_tenth_of_the_error_is_given_for_a_smaller_change(double second, CorrectionKind kind)
    {
        var noisy = Case("\"tool-wear\", \"blocks\"", ", \"stepMm\": 0.1, \"withinMm\": 0") with
        {
            Gauge = """ "uncertaintyMm": 0.003 """,
            Part = FormattableString.Invariant($"1 10 0.060; 2 40 {second}"),
            Features = [MatchCase.Line("L1", "N50", "1", "2", """ "toleranceMm": [-0.05, 0.05] """)],
        };
        var choice = noisy.Match().Correction!;
        Assert.Equal(kind, choice.Kind);
        if (kind == CorrectionKind.ToolWear)
        {
            Assert.InRange(choice.Expected!.LargestMm / choice.ExpectedByBlocks!.LargestMm, 1.02, 1.1);
        }
    }

    // The largest difference is by how much the two increments of the line differ from their middle: the limit, and just beyond it.
    [Theory]
    [InlineData(0.0219, CorrectionKind.ToolWear)]
    [InlineData(0.0241, CorrectionKind.Blocks)]
    public void A_micrometer_is_enough_and_two_are_not(double second, CorrectionKind kind) =>
        Assert.Equal(
            kind,
            (Case("\"tool-wear\", \"blocks\"") with
            {
                Part = FormattableString.Invariant($"1 10 0.02; 2 40 {second}")
            }).Match().Correction!.Kind);

    // The two points differ by what a gauge of 3 um cannot tell. With wide limits that is noise. With a narrow lower limit,
    // the middle radius would leave a point outside that blocks bring within.
    [Theory]
    [InlineData("[-0.05, 0.05]", CorrectionKind.ToolWear)]
    [InlineData("[-0.002, 0.05]", CorrectionKind.Blocks)]
    public void Noise_is_no_reason_to_drive_a_point_out_of_its_limits(string limits, CorrectionKind kind)
    {
        var noisy = Case("\"tool-wear\", \"blocks\"") with
        {
            Gauge = """ "uncertaintyMm": 0.003 """,
            Part = "1 10 0.060; 2 40 0.067",
            Features = [MatchCase.Line("L1", "N50", "1", "2", $""" "toleranceMm": {limits} """)],
        };
        var choice = (noisy with { More = Correction("\"tool-wear\", \"blocks\"", ", \"stepMm\": 0.1") }).Match().Correction!;
        Assert.Equal(kind, choice.Kind);
    }

    // Blocks leave the second line alone, which is within its limits, and so 8 um off. The work offset moves both.
    [Theory]
    [InlineData(0.008)]
    [InlineData(-0.008)]
    public void A_shift_of_the_whole_part_moves_what_blocks_leave_within_its_limits(double second)
    {
        var shifted = Case("\"work-offset\", \"blocks\"", MayMove) with
        {
            Program = Corner,
            Theoretical = "1 10 0; 2 40 0; 3 45 -30; 4 25 -30; 5 50 -8; 6 50 -22",
            Part = FormattableString.Invariant($"1 10 0.03; 2 40 0.03; 3 45 -29.97; 4 25 -29.97; 5 {50 + second} -8; 6 {50 + second} -22"),
            Gauge = """ "uncertaintyMm": 0.0005 """,
            Features =
            [
                MatchCase.Line("L1", "N50", "1", "2", """ "toleranceMm": [-0.012, 0.012] """),
                MatchCase.Line("L2", "N60", "5", "6", """ "toleranceMm": [-0.012, 0.012] """),
                MatchCase.Line("L3", "N70", "3", "4", """ "toleranceMm": [-0.012, 0.012] """),
            ],
        };
        var match = shifted.Match();
        Assert.Equal(CorrectionKind.WorkOffset, match.Correction!.Kind);
        Assert.Equal(new((decimal)second, UpMm + 0.010m, 0), match.Correction.Work!.Total);
        Assert.InRange(match.Correction.ExpectedByBlocks!.LargestMm, 0.0079, 0.0082);
        Assert.InRange(match.Correction.Expected!.LargestMm, 0, 0.001);
        Assert.All(match.Prediction.Features.SelectMany(f => f.Points), p => Assert.InRange(p.AfterMm, -0.0001, 0.0001));
    }

    [Theory]
    [InlineData(", \"stepMm\": 0.02", CorrectionKind.ToolWear)]
    [InlineData(", \"stepMm\": 0.0199", CorrectionKind.Blocks)]
    [InlineData(", \"totalMm\": 0.02", CorrectionKind.ToolWear)]
    [InlineData(", \"totalMm\": 0.0199", CorrectionKind.Blocks)]
    public void Limits_hold_for_the_step_and_the_sum(string limit, CorrectionKind kind) =>
        Assert.Equal(kind, Case(All, limit).Match().Correction!.Kind);

    [Fact]
    public void In_feedback_the_correction_follows_the_one_before()
    {
        var first = Feedback("1 10 -0.02; 2 40 -0.02", null);
        Assert.Equal(new(7, 0, Toward, 0), first.Correction!.Radius);

        // The second counterpart is off by 3 um: the mean of both is corrected, and the control must have the correction before.
        var second = Feedback("1 10 0.003; 2 40 0.003", new("report.json", "", first.Lot!.Pieces) { Offsets = new(Toward, default) });
        Assert.Equal(new(7, 0, Toward - 0.002m, Toward), second.Correction!.Radius);
        Assert.Contains("IF[ABS[#502-[0.02]]LT0.0006]", Encoding.ASCII.GetString(second.Correction.Program!), StringComparison.Ordinal);

        // A lot that begins anew says nothing of the counterparts before, and still follows the correction before.
        var anew = new PreviousMatch("report.json", "", new(["1", "2"], [], [0, 0])) { Offsets = new(Toward, default) };
        var third = Feedback("1 10 -0.01; 2 40 -0.01", anew);
        Assert.Equal(new(7, 0, Toward + 0.010m, Toward), third.Correction!.Radius);
    }

    [Fact]
    public void Nothing_to_correct_takes_earlier_corrections_back()
    {
        var match = (Case(All) with { Part = "1 10 0; 2 40 0" }).Match();
        Assert.Equal((null, 0m), (match.Correction!.Kind, match.Correction.Radius!.TotalMm));
        Assert.Contains("R[#501+[0.0]]", Encoding.ASCII.GetString(match.Correction.Program!), StringComparison.Ordinal);
        var verdict = MatchReporter.Report(match, "out/a.nc", null).Verdict;
        Assert.Contains("takes earlier corrections out", verdict.OffsetsToDo, StringComparison.Ordinal);
    }

    [Fact]
    public void Where_blocks_cannot_follow_an_offset_may()
    {
        // A corner that the control rounds itself.
        var rounded = Case(All, MayMove) with { Program = Line.Replace("N50 X50.", "N50 X50. ,R3.\nN60 Y-20.", StringComparison.Ordinal) };
        Assert.Equal("corner-word", (rounded with { More = "" }).Refusal().Code);
        var match = rounded.Match();
        Assert.Equal(CorrectionKind.ToolWear, match.Correction!.Kind);

        // What blocks would leave is not said of blocks that cannot be.
        Assert.Null(match.Correction.ExpectedByBlocks);
        var why = CorrectionWords.Why(MatchReporter.Report(match, "out/a.nc", null).Correction!).Last();
        Assert.Contains("blocks cannot follow", why, StringComparison.Ordinal);
    }

    [Fact]
    public void The_report_keeps_all_of_it()
    {
        var report = MatchReporter.Report(Case(All).Match(), "out/a.nc", null);
        var read = MatchReportJson.Read(Reporting.ReportReader.Document(MatchReportJson.Write(report)));
        Assert.Equal((report.Correction!.Choice with { Program = null }).Radius, read.Correction!.Choice.Radius);
        Assert.Equal(report.Correction.Totals, read.Correction.Totals);
        Assert.Equal(Path.Combine("out", "offsets.nc"), read.Correction.File);
        Assert.Contains("run offsets.nc before it", VerdictWords.Of(read.Verdict), StringComparison.Ordinal);
        Assert.True(read.IsUnchanged && read.IsCorrected);
    }

    [Fact]
    public void Variables_are_not_guessed()
    {
        var problem = Assert.Single(Assert.Throws<InputException>(
            () => (Case(All) with { More = """ "correction": { "allow": ["tool-wear"] }, """ }).Job).Refusals);
        Assert.Equal("first-variable-missing", problem.Code);
    }

    // Tool left of a line along X: the part says that it should stand 20 um further up, which is toward the tool.
    private const double Up = 0.02;
    private const decimal UpMm = 0.020m;
    private const decimal Toward = 0.020m;

    private static MatchResult Feedback(string counterpart, PreviousMatch? previous)
    {
        var input = (Case(All) with
        {
            Part = "1 10 0; 2 40 0",
            Counterpart = counterpart,
            Compensation = """{ "from": "counterpart" }""",
            Gauge = """ "uncertaintyMm": 0.001 """,
        }).Input;
        var outcome = Matcher.Match(input with { Previous = previous });
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        return outcome.Result;
    }

    private static MatchCase Case(string allow, string more = "") => new(Line)
    {
        Theoretical = "1 10 0; 2 40 0",
        Part = FormattableString.Invariant($"1 10 {Up}; 2 40 {Up}"),
        More = Correction(allow, more),
    };

    private static string Correction(string allow, string more = "") =>
        $$""" "correction": { "allow": [{{allow}}], "firstVariable": 500{{more}} }, """;
}
