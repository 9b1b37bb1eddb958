using System.Text;

namespace ErrorMatching.Mating.Tests;

/// <summary>What of a deviation reaches the program: whole, excess, nothing; feed-forward and feedback.</summary>
public sealed class DecisionMatchTests
{
    private static string[] Limits(string toleranceMm) => [MatchCase.Line("L1", "N50", "1", "2", $""" "toleranceMm": {toleranceMm} """)];

    [Fact]
    public void Feedback_displaces_the_program_by_part_less_counterpart()
    {
        // The program cut a counterpart at -0.04; the part is at 0.1, so the program must go 0.14 up.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = """{ "from": "counterpart" }"""
        };
        var point = match.Report().KeyPoints[0];

        Assert.Equal(["N40 G1 X0. Y-2.86 F300"], match.Changed());
        Assert.Equal(
            (-0.14, -0.1, 0.14, 0),
            (
                Math.Round(point.DecidedMm, 9),
                Math.Round(point.NormalMm, 9),
                Math.Round(point.Correction.Y, 9),
                Math.Round(point.PredictedMm, 6)));
        Assert.Equal(-0.04, point.Counterpart!.Value.Y, 9);
    }

    [Fact]
    public void Feedback_with_half_the_gain_goes_half_the_way()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = """{ "from": "counterpart", "gain": 0.5 }"""
        };

        Assert.Equal(["N40 G1 X0. Y-2.93 F300"], match.Changed());
        Assert.Equal(0.07, match.Report().KeyPoints[0].PredictedMm, 6);
    }

    [Fact]
    public void A_counterpart_that_fits_is_cut_again_by_the_same_program()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 0.1; 2 40 0.1",
            Compensation = """{ "from": "counterpart" }"""
        };

        Unchanged(match, Decision.WithinTolerance);
    }

    [Fact]
    public void Feed_forward_does_not_look_at_a_counterpart()
    {
        var match = new MatchCase(Programs.ToolBelow) { Counterpart = "1 10 -0.04; 2 40 -0.04" };

        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], match.Changed());
        Assert.Null(match.Report().KeyPoints[0].Counterpart);
    }

    [Fact]
    public void Outside_its_tolerance_the_whole_deviation_is_compensated()
    {
        var match = new MatchCase(Programs.ToolBelow) { Features = Limits("[-0.03, 0.5]") };

        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], match.Changed());
        Assert.Equal(-0.07, match.Report().KeyPoints[0].ExcessMm, 9);
    }

    [Fact]
    public void On_request_only_what_exceeds_the_limit_is_compensated()
    {
        // The normal points down, so 0.1 up is -0.1, which is 0.07 beyond the lower limit; the upper one does not matter.
        var match = new MatchCase(Programs.ToolBelow) { Features = Limits("[-0.03, 0.5]"), Compensation = """{ "amount": "excess" }""" };

        Assert.Equal(["N40 G1 X0. Y-2.93 F300"], match.Changed());
        Assert.Equal(0.03, match.Report().KeyPoints[0].PredictedMm, 6);
    }

    [Fact]
    public void Excess_is_taken_point_by_point()
    {
        // Excess 0 at 10 and 0.09 at 40: -0.03 at 0, 0.12 at 50.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Part = "1 10 0.01; 2 40 0.12",
            Features = Limits("[-0.03, 0.03]"),
            Compensation = """{ "amount": "excess" }"""
        };

        Assert.Equal(["N40 G1 X0. Y-3.03 F300", "N50 X50. Y-2.88"], match.Changed());
    }

    [Fact]
    public void The_excess_of_a_vector_is_the_same_share_of_it_as_of_its_normal_part()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Part = "1 10.2 0.1; 2 40.2 0.1",
            Features = Limits("[-0.03, 0.5]"),
            Compensation = """{ "amount": "excess", "along": "vector" }"""
        };
        var point = match.Report().KeyPoints[0];

        Assert.Equal((0.14, 0.07), (Math.Round(point.Correction.X, 9), Math.Round(point.Correction.Y, 9)));
    }

    [Theory]
    [InlineData("[-0.1, 0]")]
    [InlineData("[-0.2, -0.05]")]
    public void Within_the_tolerance_the_program_stays_as_it_is_to_the_byte(string toleranceMm) =>
        Unchanged(new MatchCase(Programs.ToolBelow) { Features = Limits(toleranceMm) }, Decision.WithinTolerance);

    [Fact]
    public void A_deviation_that_the_gauge_cannot_tell_from_nothing_is_not_compensated() =>
        Unchanged(new MatchCase(Programs.ToolBelow) { Gauge = """ "uncertaintyMm": 0.05 """ }, Decision.NotSignificant);

    // 0.08 beside an uncertainty of 0.03: significant alone (2 * 0.03), not as a difference of two measurements (2 * 0.03 * 1.414 = 0.085).
    [Fact]
    public void Feedback_compares_two_measurements_and_needs_more_to_be_significant()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Gauge = """ "uncertaintyMm": 0.03 """,
            Part = "1 10 0.08; 2 40 0.08",
            Counterpart = "1 10 0; 2 40 0"
        };

        Assert.Equal(Decision.Compensated, match.Match().Decision.Features[0].Decision);
        Unchanged(match with { Compensation = """{ "from": "counterpart" }""" }, Decision.NotSignificant);
    }

    [Fact]
    public void A_correction_below_half_an_increment_leaves_the_program_and_says_so()
    {
        var match = new MatchCase(Programs.ToolBelow) { Part = "1 10 0.0003; 2 40 0.0003" };

        Unchanged(match, Decision.Compensated);
        Assert.Contains(match.Report().Notes, n => n.Contains("least increment", StringComparison.Ordinal));
    }

    [Fact]
    public void Only_the_feature_outside_its_tolerance_moves()
    {
        // The right side x = 50 (material left of it, tool at 53) is 0.02 off and allowed to be; the boundary y = 0 is not.
        var program = "N20 G0 X-20. Y-3.\nN40 G1 X0. F300\nN50 X53.\nN60 Y40.\nN70 G0 Z50.\nN80 M30\n";
        var match = new MatchCase(program)
        {
            Theoretical = "1 10 0; 2 40 0; 3 50 10; 4 50 30",
            Part = "1 10 0.1; 2 40 0.1; 3 50.02 10; 4 50.02 30",
            Features = [
                MatchCase.Line("L1", "N40..N50", "1", "2"), MatchCase.Line("L2", "N60", "3", "4", """ "toleranceMm": [-0.05, 0.05] """)],
        };
        var report = match.Report();

        Assert.Equal([Decision.Compensated, Decision.WithinTolerance], report.Features.Select(f => f.Decision));
        Assert.Equal(["N20 G0 X-20. Y-2.9"], match.Changed());
        Assert.Equal([0, 0, -0.02, -0.02], report.KeyPoints.Select(p => Math.Round(p.PredictedMm, 6)));
        Assert.All(report.KeyPoints.Skip(2), p => Assert.Equal(0, p.Correction.Length));
        Assert.Null(report.RadiusWearMm);
    }

    [Fact]
    public void Every_cut_of_a_feature_is_displaced_alike()
    {
        var program = "N20 G0 X0. Y-20.\nN30 G1 Z-2. F300\nN40 Y-3.\nN50 X50.\nN60 Y-20.\nN70 G0 Z5.\nN120 X50. Y-20.\nN130 G1 Z-4.\nN140 "
            + "Y-3.\nN150 X0.\nN160 Y-20.\nN170 M30\n";
        var match = new MatchCase(program) { Features = [MatchCase.Line("L1", "N50 N150", "1", "2")] };

        Assert.Equal(["N40 Y-2.9", "N140 Y-2.9"], match.Changed());
        Assert.Equal(2, match.Match().Maps[0].Passes.Count);
        Assert.Contains(match.Report().Notes, n => n.Contains("2 passes", StringComparison.Ordinal));
        Assert.Equal(["N50", "N150"], match.Report().KeyPoints[0].Blocks);
    }

    // Tool below, part 0.1 higher: the tool must come 0.1 nearer to the material, as if it were 0.1 thinner.
    [Theory]
    [InlineData(Programs.ToolBelow, -0.1)]
    [InlineData(Programs.ToolAbove, 0.1)]
    public void A_uniform_offset_is_also_a_radius_wear(string program, double wearMm)
    {
        Assert.Equal(wearMm, new MatchCase(program).Report().RadiusWearMm!.Value, 9);
        Assert.Null((new MatchCase(program) { Part = "1 10 0.1; 2 40 0.102" }).Report().RadiusWearMm);
    }

    [Fact]
    public void Measuring_takes_the_time_of_equation_7()
    {
        // 2 points * 5 mm / 10 mm/s + 1 s.
        var time = new MatchCase(Programs.ToolBelow).Report().Time;

        Assert.Equal((2, 0.25), (time.MeasuringS, time.CalculatingS));
    }

    [Fact]
    public void A_point_on_a_corner_that_the_tool_rounds_is_warned_of()
    {
        // The path turns away from the material at (50, -3): there the boundary is the tool's circle,
        // and this point lies at 45 degrees on it.
        var match = new MatchCase(Programs.ToolBelow) { Theoretical = "1 10 0; 2 52.121 -0.879", Part = "1 10 0.1; 2 52.121 -0.779" };

        Assert.Contains(
            match.Report().Warnings,
            w => w is { Code: "point-on-corner", Values: ["2", "N50"] });
        Assert.DoesNotContain(
            new MatchCase(Programs.ToolBelow).Report().Warnings, w => w.Message.Contains("corner", StringComparison.Ordinal));
    }

    private static void Unchanged(MatchCase match, Decision decision)
    {
        var result = match.Match();

        Assert.Equal(match.Program, Encoding.Latin1.GetString(result.Program.Span));
        Assert.Equal((null, null, 0), (result.Marker, result.Proof.Marker, result.Proof.MovedMotions));
        Assert.All(result.Decision.Features, f => Assert.Equal(decision, f.Decision));
        Assert.Equal((0, 0), (match.Report().Program.ChangedBlocks, match.Report().Program.ChangedWords));
    }
}
