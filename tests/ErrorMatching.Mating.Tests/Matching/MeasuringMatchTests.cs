namespace ErrorMatching.Mating.Tests;

/// <summary>What is done to measured coordinates before they are compared: stylus centers and alignments.</summary>
public sealed class MeasuringMatchTests
{
    private const string Ball = """ "uncertaintyMm": 1e-7, "reports": "stylus-center", "stylusDiameterMm": 2 """;

    // The part fills the tool's room below y = 0; its gauge touches it from above, so the ball's center is 1 mm over the boundary.
    // The tool above: all the other way round.
    [Theory]
    [InlineData(Programs.ToolBelow, "1 10 1.1; 2 40 1.1", "N40 G1 X0. Y-2.9 F300")]
    [InlineData(Programs.ToolAbove, "1 10 -0.9; 2 40 -0.9", "N40 G1 X0. Y3.1 F300")]
    [InlineData(Programs.CompensatedLeft, "1 10 -0.9; 2 40 -0.9", "N40 X0. Y0.1")]
    public void The_ball_on_the_part_stands_where_the_counterparts_material_will_be(string program, string centers, string changed)
    {
        var match = new MatchCase(program) { Gauge = Ball, Part = centers };

        Assert.Equal([changed], match.Changed());
        Assert.Equal(0.1, match.Report().KeyPoints[0].Actual.Y, 9);
    }

    [Fact]
    public void The_ball_on_the_counterpart_stands_where_the_tool_was()
    {
        // The counterpart came out at -0.04: its ball's center is 1 mm below that. Part at 0.1: 0.14 to go.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Gauge = Ball,
            Part = "1 10 1.1; 2 40 1.1",
            Counterpart = "1 10 -1.04; 2 40 -1.04",
            Compensation = """{ "from": "counterpart" }"""
        };

        Assert.Equal(["N40 G1 X0. Y-2.86 F300"], match.Changed());
        Assert.Equal(-0.04, match.Report().KeyPoints[0].Counterpart!.Value.Y, 9);
    }

    [Fact]
    public void In_a_mirrored_frame_the_ball_is_still_on_the_parts_own_side()
    {
        // y to -y: in the part's frame the tool is above, so the part is above and the ball below.
        var match = new MatchCase(Programs.ToolBelow) { Gauge = Ball, Frame = """{ "mirror": "y" }""", Part = "1 10 -0.9; 2 40 -0.9" };

        Assert.Equal(["N40 G1 X0. Y-3.1 F300"], match.Changed());
    }

    [Fact]
    public void A_datum_takes_out_how_the_part_was_clamped()
    {
        // Measured after a quarter turn, (x, y) to (-y, x), and a shift by (5, 5); the boundary is 0.1 high as ever.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Theoretical = "1 10 0; 2 40 0; O 0 -10; D 50 -10",
            Part = "1 4.9 15; 2 4.9 45; O 15 5; D 15 55",
            More = """ "alignment": { "kind": "datum", "origin": "O", "direction": "D" }, """,
        };
        var report = match.Report();

        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], match.Changed());
        Assert.Equal((10, 0.1), (Math.Round(report.KeyPoints[0].Actual.X, 9), Math.Round(report.KeyPoints[0].Actual.Y, 9)));
        Assert.Contains(report.Warnings, w => w.Message.Contains("aligned (datum)", StringComparison.Ordinal));
    }

    // As above with a ball of radius 1 over the boundary: its center was at (10, 1.1) before the turn.
    [Theory]
    [InlineData(""" "alignment": { "kind": "datum", "origin": "O", "direction": "D" }, """)]
    [InlineData(""" "alignment": { "kind": "best-fit" }, """)]
    public void A_ball_is_aligned_before_it_is_taken_to_the_contact(string alignment)
    {
        // The upright element at x = 50 holds the best fit: the tool is right of it, its ball left of it.
        var match = new MatchCase(Programs.ToolBelow.Replace("N50 X50.\nN60 Y-20.", "N50 X53.\nN60 Y40.", StringComparison.Ordinal))
        {
            Theoretical = "1 10 0; 2 40 0; 3 50 10; 4 50 30; O 0 -10; D 50 -10",
            Part = "1 4 15; 2 4 45; 3 -5 54; 4 -25 54; O 15 5; D 15 55",
            Features = [MatchCase.Line("L1", "N50", "1", "2"), MatchCase.Line("L2", "N60", "3", "4")],
            Gauge = Ball,
            More = alignment,
        };

        Assert.All(match.Report().KeyPoints, p => Assert.Equal(0, p.Actual.DistanceTo(p.Theoretical), 9));
        Assert.All(match.Report().Alignments, a => Assert.Equal(0, a.RmsMm, 9));
    }

    [Fact]
    public void A_best_fit_hides_an_error_that_looks_like_clamping_unless_it_is_locked()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Part = "1 10.2 0.1; 2 40.2 0.1",
            More = """ "alignment": { "kind": "best-fit" }, """
        };

        Assert.Equal(Decision.WithinTolerance, match.Match().Decision.Features[0].Decision);

        var locked = match with { More = """ "alignment": { "kind": "best-fit", "locked": ["y", "rotation"] }, """ };
        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], locked.Changed());
        Assert.Equal(
            (10, 0.1), (Math.Round(locked.Report().KeyPoints[0].Actual.X, 9), Math.Round(locked.Report().KeyPoints[0].Actual.Y, 9)));
    }

    [Fact]
    public void A_turn_that_is_locked_stays_in_the_deviation()
    {
        // 0.1 at 10 and 0.2 at 40: the shift of 0.15 is free and goes, the slope stays:
        // -0.05 and 0.05, which is -0.0833 at 0 and 0.0833 at 50.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Part = "1 10 0.1; 2 40 0.2",
            More = """ "alignment": { "kind": "best-fit", "locked": ["rotation"] }, """
        };

        Assert.Equal(["N40 G1 X0. Y-3.083 F300", "N50 X50. Y-2.917"], match.Changed());
        Assert.Equal(0.05, match.Report().Alignments[0].RmsMm, 9);
    }

    [Fact]
    public void An_origin_within_its_limit_is_reported()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Theoretical = "1 10 0; 2 40 0; O 0 0",
            Part = "1 10 0.1; 2 40 0.1; O 0.003 0.004",
            More = """ "originCheck": { "point": "O", "limitMm": 0.01 }, """,
        };

        Assert.Equal(0.005, match.Report().OriginCheck!.DistanceMm, 9);
    }
}
