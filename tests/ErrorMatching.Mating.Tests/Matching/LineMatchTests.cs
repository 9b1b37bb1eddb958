namespace ErrorMatching.Mating.Tests;

/// <summary>A straight boundary, by hand: sign and size of every number and the one word that changes.</summary>
public sealed class LineMatchTests
{
    // The part ends 0.1 higher than designed; whatever side the counterpart is on, its boundary must end 0.1 higher too.
    [Theory]
    [InlineData(Programs.ToolBelow, "N40 G1 X0. Y-2.9 F300", -0.1)]
    [InlineData(Programs.ToolAbove, "N40 G1 X0. Y3.1 F300", 0.1)]
    [InlineData(Programs.CompensatedLeft, "N40 X0. Y0.1", 0.1)]
    [InlineData(Programs.CompensatedRight, "N40 X0. Y0.1", -0.1)]
    public void The_boundary_moves_with_the_part_whatever_side_the_tool_is_on(string program, string changed, double normalMm)
    {
        var match = new MatchCase(program);
        var report = match.Report();

        Assert.Equal([changed], match.Changed());
        Assert.All(report.KeyPoints, p =>
        {
            Near((0, 0.1), (p.Correction.X, p.Correction.Y));
            Near((0, -0.1), (p.Deviation.X, p.Deviation.Y));
            Near((0, Math.Sign(normalMm)), (p.Normal.X, p.Normal.Y));
            Assert.Equal(normalMm, p.NormalMm, 9);
            Assert.Equal(normalMm, p.DecidedMm, 9);
            Assert.Equal(0, p.PredictedMm, 6);
            Assert.Equal(["N50"], p.Blocks);
        });
        Assert.Equal((1, 1), (report.Program.ChangedBlocks, report.Program.ChangedWords));
        Assert.Equal(normalMm, report.Features[0].LargestMm, 9);
    }

    [Fact]
    public void A_tool_that_goes_the_other_way_changes_nothing_but_the_blocks()
    {
        var back = "N20 G0 X50. Y-20.\nN40 G1 X50. Y-3. F300\nN50 X0.\nN60 Y-20.\nN70 M30\n";

        Assert.Equal(["N40 G1 X50. Y-2.9 F300"], new MatchCase(back).Changed());
    }

    // Arcs in G18 lead the tool down to the boundary and up again: where it moves by 0.1, the rapid before them does.
    [Theory]
    [InlineData("N50")]
    [InlineData("N45..N55")]
    public void Upright_arcs_follow_the_boundary(string blocks)
    {
        var led = "N10 G21 G90 G17\nN20 G0 X-2. Y-3.\nN30 Z2.\nN45 G18 G2 X0. Z0. I2. K0. F300\nN50 G1 X50.\nN55 G18 G2 X52. Z2. K2.\n"
            + "N60 G0 Z50.\nN80 M30\n";
        var match = new MatchCase(led) { Features = [MatchCase.Line("L1", blocks, "1", "2")] };

        Assert.Equal(["N20 G0 X-2. Y-2.9"], match.Changed());
    }

    [Fact]
    public void A_line_shifts_and_tilts()
    {
        // Through 0.1 at 10 and 0.2 at 40: 0.0667 at 0, 0.2333 at 50, where the neighbors stand upright.
        var match = new MatchCase(Programs.ToolBelow) { Part = "1 10 0.1; 2 40 0.2" };

        Assert.Equal(["N40 G1 X0. Y-2.933 F300", "N50 X50. Y-2.767"], match.Changed());
    }

    // 0.05, 0.2, 0.05 at 10, 25, 40 have the mean 0.1 and no slope. The gauge may scatter by as much, so nothing tells a bent line.
    [Fact]
    public void More_points_are_a_least_squares_line()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Theoretical = "1 10 0; 2 25 0; 3 40 0",
            Part = "1 10 0.05; 2 25 0.2; 3 40 0.05",
            Features = [MatchCase.Feature("line", "L1", "N50", """["1..3"]""")],
            Gauge = """ "uncertaintyMm": 0.07, "acceptCoarse": true """,
        };
        var wish = Assert.Single(match.Match().Wish!.Elements);

        Assert.Equal(wish.Start.Y, wish.End.Y, 1e-6);
        Assert.Equal(0.1, wish.Start.Y, 0.003);

        // What is left is the distance of the points: (0.1 - 0.05) * -1, (0.1 - 0.2) * -1 along (0, -1).
        Assert.All(
            match.Report().KeyPoints.Zip([-0.05, 0.1, -0.05]), p => Assert.Equal(p.Second, p.First.PredictedMm, 0.004));
    }

    [Fact]
    public void What_lies_along_the_boundary_is_not_compensated()
    {
        var match = new MatchCase(Programs.ToolBelow) { Part = "1 10.3 0.1; 2 40.3 0.1" };

        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], match.Changed());
        Assert.All(match.Report().KeyPoints, p => Near((0, 0.1), (p.Correction.X, p.Correction.Y)));
    }

    [Fact]
    public void Along_the_vector_the_correction_is_the_difference_of_the_points()
    {
        var match = new MatchCase(Programs.ToolBelow) { Part = "1 10.3 0.1; 2 40.3 0.1", Compensation = """{ "along": "vector" }""" };

        Assert.All(match.Report().KeyPoints, p => Near((0.3, 0.1), (p.Correction.X, p.Correction.Y)));
        // A line that is displaced along itself is the same line, so the upright neighbors keep their x.
        Assert.Equal(["N40 G1 X0. Y-2.9 F300"], match.Changed());
    }

    [Fact]
    public void A_mirrored_frame_mirrors_the_correction()
    {
        // y to -y: the part's 0.1 up is 0.1 down in the program. The tool is below there, above in the part's frame.
        var report = new MatchCase(Programs.ToolBelow) { Frame = """{ "mirror": "y" }""" }.Report();

        Assert.Equal(["N40 G1 X0. Y-3.1 F300"], new MatchCase(Programs.ToolBelow) { Frame = """{ "mirror": "y" }""" }.Changed());
        Near((0, -0.1), (report.KeyPoints[0].Correction.X, report.KeyPoints[0].Correction.Y));
        Near((0, 1), (report.KeyPoints[0].Normal.X, report.KeyPoints[0].Normal.Y));
        Assert.Equal((0.1, 0.1), (Math.Round(report.KeyPoints[0].NormalMm, 9), Math.Round(report.KeyPoints[0].DecidedMm, 9)));
        Assert.Equal(0, report.KeyPoints[0].PredictedMm, 6);
    }

    [Fact]
    public void A_quarter_turn_turns_the_correction()
    {
        // (x, y) to (-y, x), then 80 to the left: the boundary stands upright at x = -80, the tool is right of it,
        // and 0.1 up is 0.1 to the left.
        var program = "N20 G0 X-60. Y0.\nN40 G1 X-77. F300\nN50 Y50.\nN60 X-60.\nN70 M30\n";
        var match = new MatchCase(program) { Frame = """{ "rotateDeg": 90, "translateMm": [-80, 0] }""" };
        var point = match.Report().KeyPoints[0];

        Assert.Equal(["N40 G1 X-77.1 F300"], match.Changed());
        Near((-0.1, 0), (point.Correction.X, point.Correction.Y));
        Near((0, -1), (point.Normal.X, point.Normal.Y));
        Assert.Equal(-0.1, point.NormalMm, 9);
    }

    [Theory]
    [InlineData("0.5", "N40 G1 X0. Y-2.95 F300", 0.05)]
    [InlineData("2", "N40 G1 X0. Y-2.8 F300", -0.1)]
    public void Gain_scales_the_correction_and_leaves_the_rest(string gain, string changed, double left)
    {
        var match = new MatchCase(Programs.ToolBelow) { Compensation = $$"""{ "gain": {{gain}} }""" };

        Assert.Equal([changed], match.Changed());
        // Counterpart - part along (0, -1): (0.05 - 0.1) * -1 and (0.2 - 0.1) * -1.
        Assert.Equal(left, match.Report().KeyPoints[0].PredictedMm, 6);
    }

    [Fact]
    public void Inches_are_rewritten_in_inches()
    {
        // A 1 inch tool: the path is half an inch below. 0.254 mm are 0.01 in.
        var program = "N10 G20 G90 G17\nN20 G0 X0. Y-1.\nN40 G1 X0. Y-.5 F12\nN50 X2.\nN60 Y-1.\nN70 M30\n";
        var match = new MatchCase(program) { ToolDiameterMm = 25.4, Part = "1 10 0.254; 2 40 0.254" };

        Assert.Equal(["N40 G1 X0. Y-.49 F12"], match.Changed());
        Assert.Equal(0, match.Report().KeyPoints[0].PredictedMm, 6);
    }

    [Theory]
    [InlineData(
        "ZX",
        "N10 G21 G90 G18\nN20 G0 X0. Z-20. Y7.\nN40 G1 Z-3. F300\nN50 X50.\nN60 Z-20.\nN70 M30\n",
        "1 10 7 0; 2 40 7 0",
        "1 10 7.02 0.1; 2 40 7 0.1",
        "N40 G1 Z-2.9 F300",
        0.02)]
    [InlineData(
        "YZ",
        "N10 G21 G90 G19\nN20 G0 Y0. Z-20. X7.\nN40 G1 Z-3. F300\nN50 Y50.\nN60 Z-20.\nN70 M30\n",
        "1 7 10 0; 2 7 40 0",
        "1 7.03 10 0.1; 2 7 40 0.1",
        "N40 G1 Z-2.9 F300",
        0.03)]
    public void A_feature_in_another_plane_is_matched_there_and_says_what_stands_out(
        string plane, string program, string theoretical, string part, string changed, double standsOut)
    {
        var match = new MatchCase(program)
        {
            Theoretical = theoretical,
            Part = part,
            Features = [MatchCase.Line("L1", "N50", "1", "2", $""" "toleranceMm": [0, 0], "plane": "{plane}" """)]
        };
        var report = match.Report();

        Assert.Equal([changed], match.Changed());
        Assert.Equal(-0.1, report.KeyPoints[0].NormalMm, 9);
        Assert.Equal(standsOut, report.Features[0].StandsOutMm!.Value, 9);
        Assert.Contains(report.Notes, n => n.StartsWith("Point 1 stands +0.0", StringComparison.Ordinal));
    }

    private static void Near((double X, double Y) expected, (double X, double Y) found)
    {
        Assert.Equal(expected.X, found.X, 9);
        Assert.Equal(expected.Y, found.Y, 9);
    }
}
