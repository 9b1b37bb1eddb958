using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>Every refusal with its code and its place, and no program beside it.</summary>
public sealed class RefusalMatchTests
{
    private static readonly MatchCase Good = new(Programs.ToolBelow);

    [Fact]
    public void A_wrong_frame_shows_at_the_first_point() =>
        Refused(
            Good with { Frame = """{ "translateMm": [0, 0.6] }""" },
            FeatureMapper.PointOffPath,
            "L1",
            "1",
            "N50",
            7,
            "lies 3.600 mm from the path, expected 3 mm");

    [Fact]
    public void A_wrong_tool_diameter_shows_at_the_first_point() =>
        Refused(
            Good with { ToolDiameterMm = 8 },
            FeatureMapper.PointOffPath,
            "L1",
            "1",
            "N50",
            7,
            "lies 3.000 mm from the path, expected 4 mm");

    [Fact]
    public void Under_cutter_compensation_a_point_must_lie_on_the_path() =>
        Refused(
            new MatchCase(Programs.CompensatedLeft) { Theoretical = "1 10 0; 2 40 0.6" },
            FeatureMapper.PointOffPath,
            "L1",
            "2",
            "N50",
            7,
            "on the path");

    [Fact]
    public void A_point_beyond_the_end_of_its_blocks_is_off_the_path() =>
        Refused(Good with { Theoretical = "1 10 0; 2 60 0", Part = "1 10 0.1; 2 60 0.1" }, FeatureMapper.PointOffPath, "L1", "2", "N50", 7);

    [Fact]
    public void Points_on_both_sides_do_not_tell_the_material() =>
        Refused(Good with { Theoretical = "1 10 0; 2 40 -6" }, FeatureMapper.SidesDiffer, "L1", "2", "N50", 7, "points 1 and 2");

    [Fact]
    public void Cuts_of_one_feature_must_have_the_material_on_the_same_side()
    {
        // N50 goes below the boundary, N150 above it: the boundary cannot be that of one piece.
        var both = "N20 G0 X0. Y-20.\nN30 Z-2.\nN40 G1 Y-3. F300\nN50 X50.\nN60 Y-20.\nN70 G0 Z5.\nN120 X0. Y20.\nN130 Z-2.\nN140 G1 "
            + "Y3.\nN150 X50.\nN160 Y20.\nN170 M30\n";

        Refused(
            new MatchCase(both) { Features = [MatchCase.Line("L1", "N50 N150", "1", "2")] },
            FeatureMapper.SidesDiffer,
            "L1",
            "1",
            "N150",
            10);
    }

    [Fact]
    public void Blocks_in_another_plane_do_not_cut_the_feature() =>
        Refused(
            Good with
            {
                Theoretical = "1 10 0 0; 2 40 0 0",
                Part = "1 10 0 0.1; 2 40 0 0.1",
                Features = [MatchCase.Line("L1", "N50", "1", "2", """ "toleranceMm": [0, 0], "plane": "ZX" """)]
            },
            FeatureMapper.PlaneDiffers, "L1", null, "N50", 7);

    [Fact]
    public void The_plane_must_not_change_within_a_cut() =>
        Refused(
            new MatchCase("N10 G0 Z0.\nN20 X0. Y-20.\nN40 G1 Y-3. F300\nN50 X45.\nN52 G18 X50.\nN60 G17 Y-20.\nN70 M30\n")
            {
                Features = [MatchCase.Line("L1", "N50..N52", "1", "2")]
            },
            FeatureMapper.PlaneDiffers,
            "L1",
            null,
            "N52",
            5);

    [Fact]
    public void A_block_belongs_to_one_feature() =>
        Refused(
            Good with
            {
                Theoretical = "1 10 0; 2 40 0; 3 15 0; 4 45 0",
                Part = "1 10 0.1; 2 40 0.1; 3 15 0.1; 4 45 0.1",
                Features = [MatchCase.Line("L1", "N50", "1", "2"), MatchCase.Line("L2", "N50..N60", "3", "4")],
            },
            FeatureMapper.BlocksOverlap, "L2", null, "N50", 7, "L1 and to L2");

    [Fact]
    public void A_number_that_names_no_block_is_refused() =>
        Refused(Good with { Features = [MatchCase.Line("L1", "N999", "1", "2")] }, NcRefusalCodes.BlockNotFound, "L1", null, "N999", null);

    [Fact]
    public void A_number_that_names_several_blocks_is_refused()
    {
        var refusal = (Good with { Program = Programs.ToolBelow.Replace("N60", "N50", StringComparison.Ordinal) }).Refusal();

        Assert.Equal((NcRefusalCodes.BlockAmbiguous, "L1"), (refusal.Code, refusal.Place.Feature));
    }

    [Theory]
    [InlineData("N10", "N10", 3)]
    [InlineData("N20", "N20", 4)]
    [InlineData("N30", "N30", 5)]
    public void Blocks_that_do_not_cut_are_refused(string blocks, string block, int line) =>
        Refused(Good with { Features = [MatchCase.Line("L1", blocks, "1", "2")] }, NcRefusalCodes.NoMotion, "L1", null, block, line);

    [Fact]
    public void A_deviation_that_is_not_plausible_stops_the_job()
    {
        var match = Good with { Part = "1 10 1.001; 2 40 1.2" };

        Assert.Null(match.Outcome.Result);
        Assert.Equal(
            [(RefusalForms.ImplausibleDeviation.Name, "L1", "1"), (RefusalForms.ImplausibleDeviation.Name, "L1", "2")],
            match.Outcome.Refusals.Select(r => (r.Code, r.Place.Feature!, r.Place.Point!)));
        Assert.NotNull((match with { Part = "1 10 1; 2 40 1" }).Outcome.Result);
        Assert.NotNull((match with { Compensation = """{ "limitMm": 1.3 }""" }).Outcome.Result);
    }

    [Theory]
    [InlineData("part")]
    [InlineData("counterpart")]
    public void An_origin_that_is_off_stops_the_job_before_anything_is_compared(string which)
    {
        var match = Good with
        {
            Theoretical = "1 10 0; 2 40 0; O 0 0",
            Part = "1 10 0.1; 2 40 0.1; O " + (which == "part" ? "0.03 0.04" : "0 0"),
            Counterpart = "1 10 0; 2 40 0; O " + (which == "part" ? "0 0" : "0.03 0.04"),
            Compensation = """{ "from": "counterpart" }""",
            More = """ "originCheck": { "point": "O", "limitMm": 0.01 }, """,
        };

        Refused(match, OriginCheck.OriginOff, null, "O", null, null, "0.050 mm off");
    }

    [Fact]
    public void One_alignment_cannot_serve_several_planes() =>
        Refused(
            Good with
            {
                Theoretical = "1 10 0 0; 2 40 0 0; 3 10 7 0; 4 40 7 0",
                Part = "1 10 0.1 0; 2 40 0.1 0; 3 10 7 0; 4 40 7 0",
                Features = [
                    MatchCase.Line("L1", "N50", "1", "2"),
                    MatchCase.Line("L2", "N60", "3", "4", """ "toleranceMm": [0, 0], "plane": "ZX" """)],
                More = """ "alignment": { "kind": "best-fit" }, """,
            },
            AlignedMeasurement.AlignmentNeedsOnePlane, null, null, null, null);

    [Theory]
    [InlineData("N50 X50.", "N50 X#101", NcRefusalCodes.Expression, "N50", 7)]
    [InlineData("N40 G1", "N40 G68 X0. Y0. R30.\nN45 G1", NcRefusalCodes.ActiveTransform, "N50", 8)]
    [InlineData("N50 X50.", "N50 X50. A10.", NcRefusalCodes.OtherAxis, "N50", 7)]
    [InlineData("N70 G0", "N65 GOTO 50\nN70 G0", NcRefusalCodes.EndlessLoop, "N65", 9)]
    [InlineData("N50 X50.", "N45 M98 P100\nN50 X50.", NcRefusalCodes.MissingProgram, "N45", 7)]
    [InlineData("N50 X50.", "N50 G2 X50. R1.", NcRefusalCodes.BadArc, "N50", 7)]
    public void What_a_control_computes_or_turns_cannot_be_rewritten(string found, string instead, string code, string block, int line)
    {
        Assert.Contains(found, Programs.ToolBelow, StringComparison.Ordinal);
        var refusal = (Good with { Program = Programs.ToolBelow.Replace(found, instead, StringComparison.Ordinal) }).Refusal();

        Assert.Equal((code, block, line), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.Equal(block == "N50" ? "L1" : null, refusal.Place.Feature);
    }

    [Fact]
    public void Features_that_no_longer_meet_are_refused_with_the_one_concerned()
    {
        // N50 and N60 run straight on, but the part has a step of 0.1 between them.
        var program = "N20 G0 X0. Y-20.\nN40 G1 Y-3. F300\nN50 X25.\nN60 X50.\nN70 Y-20.\nN80 M30\n";
        var refusal = (new MatchCase(program)
        {
            Theoretical = "1 5 0; 2 20 0; 3 30 0; 4 45 0",
            Part = "1 5 0.1; 2 20 0.1; 3 30 0.2; 4 45 0.2",
            Features = [MatchCase.Line("L1", "N50", "1", "2"), MatchCase.Line("L2", "N60", "3", "4")],
        }).Refusal();

        Assert.Equal(
            (NcRefusalCodes.NoIntersection, "L2", "N60", 4),
            (refusal.Code, refusal.Place.Feature, refusal.Place.Block, refusal.Place.Line));
    }

    private static void Refused(MatchCase match, string code, string? feature, string? point, string? block, int? line, string says = "")
    {
        var refusal = match.Refusal();
        var place = refusal.Place;
        Assert.Equal((code, feature, point, block, line), (refusal.Code, place.Feature, place.Point, place.Block, place.Line));
        Assert.Contains(says, refusal.Message, StringComparison.Ordinal);
    }
}
