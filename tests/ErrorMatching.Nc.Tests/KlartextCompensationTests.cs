using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>The path of the tool's center under RL and RR. Places are those of a drawing, for a tool radius of 3 mm.</summary>
public sealed class KlartextCompensationTests
{
    private const string Head = "0 BEGIN PGM A MM\n1 TOOL CALL 4 Z S2000\n2 L X-20 Y+0 Z+5 R0 FMAX\n3 L Z-5 F200\n";

    // A path along +X from the origin, and then a corner.
    private const string Start = "L X+0 RL F100\n";

    [Fact]
    public void Compensation_begins_at_right_angles_to_the_first_element()
    {
        Assert.Equal(["Line -3 0", "Line -3 10"], Center("L X+0 RL\nL Y+10\n"));
        Assert.Equal(["Line 3 0", "Line 3 10"], Center("L X+0 RR\nL Y+10\n"));
        Assert.Equal(["Line 3 0", "Line 3 -10"], Center("L X+0 RL\nL Y-10\n"));
        Assert.Equal(["Line -3 0", "Line -3 0", "Line -3 10"], Center("L X+0 RL\nL Z-9\nL Y+10\n"));
    }

    [Fact]
    public void Compensation_ends_from_the_place_at_right_angles_to_the_last_element() => Assert.Equal(
        ["Line 0 3", "Line 10 3", "Line 12 -9", "Rapid 12 -9"], Center(Start + "L X+10\nL X+12 Y-9 R0\nL Z+9 FMAX\n"));

    [Fact]
    public void An_outside_corner_gets_a_transition_arc() => Assert.Equal(
        ["Line 0 3", "Line 10 3", "ArcClockwise 12.1213 2.1213", "Line 22.1213 -7.8787"], Center(Start + "L X+10\nL X+20 Y-10\n"));

    [Fact]
    public void An_inside_corner_is_the_intersection_of_both_paths() =>
        Assert.Equal(["Line 0 3", "Line 7 3", "Line 7 10"], Center(Start + "L X+10\nL Y+10\n"));

    [Fact]
    public void M97_goes_on_to_the_intersection_at_the_end_of_its_block()
    {
        // The lines y = 3 and x + y = 10 + 3 sqrt 2; behind the next corner x = 23.
        Assert.Equal(
            ["Line 0 3", "Line 11.2426 3", "Line 22.1213 -7.8787", "ArcClockwise 23 -10", "Line 23 -20"],
            Center(Start + "L X+10 M97\nL X+20 Y-10\nL Y-20\n"));

        // Behind a rounding, it is the corner at the end of its own block that counts.
        Assert.Equal(
            ["Line 0 3", "Line 10 3", "ArcClockwise 18 -5", "Line 18 -23", "Line 0 -23"],
            Center(Start + "L X+15\nRND R5\nL Y-20 M97\nL X+0\n"));

        // The step of half a millimeter of the manuals, and the same without M97.
        Assert.Equal(
            ["Line 0 3", "Line 13 3", "Line 13 2.5", "Line 30 2.5"], Center(Start + "L X+10 M97\nL Y-0.5\nL X+30\n"));
        Assert.Equal(("compensation-gouge", 7), Refused(Start + "L X+10\nL Y-0.5\nL X+30\n"));
    }

    [Fact]
    public void Arcs_of_all_kinds_are_led_beside()
    {
        Assert.Equal(["Line 0 3", "ArcCounterClockwise 7 10"], Center(Start + "CC X+0 Y+10\nC X+10 Y+10 DR+\n"));
        Assert.Equal(["Line 0 3", "ArcCounterClockwise 7 10"], Center(Start + "CR X+10 Y+10 R+10 DR+\n"));
        Assert.Equal(["Line 0 3", "ArcClockwise 13 -10"], Center(Start + "CR X+10 Y-10 R+10 DR-\n"));
        Assert.Equal(["Line 0 3", "Line 5 3", "ArcCounterClockwise 12 10"], Center(Start + "L X+5\nCT X+15 Y+10\n"));
        Assert.Equal(
            ["Line 0 3", "Line 10 3", "ArcClockwise 18 -5", "Line 18 -10"], Center(Start + "L X+15\nRND R5\nL Y-10\n"));
        Assert.Equal(
            ["Line 0 3", "Line 10 3", "ArcClockwise 12.1213 2.1213", "Line 17.1213 -2.8787", "ArcClockwise 18 -5", "Line 18 -10"],
            Center(Start + "L X+15\nCHF 5\nL Y-10\n"));
    }

    [Fact]
    public void Polar_ends_are_led_beside()
    {
        Assert.Equal(["Line 0 3", "Line 7 3", "Line 7 20"], Center(Start + "CC X+0 Y+0\nLP PR+10 PA+0\nCC X+10 Y+0\nLP PR+20 PA+90\n"));
        Assert.Equal(["Line 0 3", "Line 5 3", "ArcCounterClockwise 12 10"], Center(Start + "L X+5\nCC X+5 Y+10\nCTP PR+10 PA+0\n"));
        var helix = Follow(Start + "CC X+0 Y+10\nCP IPA+450 IZ-2 DR+\n");
        Assert.Null(helix.Refusal);
        Assert.Equal((1, -7.0), (helix.Motions[^1].Turns, helix.Motions[^1].End.Z));
        Assert.Equal(7, helix.Motions[^1].Center.DistanceTo(new(helix.Motions[^1].End.X, helix.Motions[^1].End.Y)), 9);

        // A rotation is another matter.
        const string rotated = "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+20\nCC X+0 Y+0\n";
        Assert.Equal("compensation-unfollowed", Refused(Start + rotated + "LP PR+10 PA+0\n")?.Code);
        Assert.Equal("compensation-unfollowed", Refused(Start + rotated + "CP IPA+90 DR+\n")?.Code);
    }

    [Fact]
    public void An_approach_goes_over_its_auxiliary_point()
    {
        // Along the contour 7 mm ahead of it; at right angles 7 mm beside the tool's place.
        Assert.Equal(["Line -7 3", "Line 0 3", "Line 10 3"], Center("APPR LT X+0 Y+0 LEN7 RL F100\nL X+10\n"));
        Assert.Equal(["Line 0 10", "Line 0 3", "Line 10 3"], Center("APPR LN X+0 Y+0 LEN7 RL F100\nL X+10\n"));
        Assert.Equal(["Line 0 -10", "Line 0 -3", "Line 10 -3"], Center("APPR LN X+0 Y+0 LEN+7 RR F100\nL X+10\n"));

        // An arc to the left about (0, 10) begins along +X; the tool first goes in the plane, then to the depth.
        Assert.Equal(
            ["Line -7 3", "Line -7 3", "Line 0 3", "ArcCounterClockwise 7 10"],
            Center("APPR LT X+0 Y+0 Z-8 LEN7 RL F100\nCC X+0 Y+10\nC X+10 Y+10 DR+\n"));
        var motions = Follow("APPR LT X+0 Y+0 Z-8 LEN7 RL F100\nL X+10\n").Motions;
        Assert.Equal([-5, -8, -8, -8], motions.Skip(2).Select(m => m.End.Z));
        Assert.Equal("Rapid", Follow("L X-20 Y+1 FMAX\nAPPR LT X+0 Y+0 LEN7 RL F100\nL X+10\n").Motions[3].Kind.ToString());
    }

    [Fact]
    public void Of_an_approach_on_an_arc_only_the_end_is_known()
    {
        Assert.Equal(["Spline 0 3", "Line 10 3"], Center("APPR CT X+0 Y+0 CCA90 R+8 RL F100\nL X+10\n"));
        Assert.Equal(["Spline 0 3", "Line 10 3"], Center("APPR LCT X+0 Y+0 R8 RL F100\nL X+10\n"));
    }

    [Fact]
    public void A_departure_goes_on_or_away_by_its_length()
    {
        Assert.Equal(["Line 0 3", "Line 10 3", "Line 15 3", "Rapid 15 3"], Center(Start + "L X+10\nDEP LT LEN5\nL Z+50 FMAX\n"));
        Assert.Equal(["Line 0 3", "Line 10 3", "Line 10 8", "Line 10 8"], Center(Start + "L X+10\nDEP LN LEN5 Z+2\n"));
        Assert.Equal(["Line 0 -3", "Line 10 -3", "Line 10 -8"], Center("L X+0 RR\nL X+10\nDEP LN LEN5\n"));
        Assert.Equal(["Line 0 3", "ArcCounterClockwise 7 10", "Line 7 15"],
            Center(Start + "CR X+10 Y+10 R+10 DR+\nDEP LT LEN5\n"));
        Assert.Equal(["Line 0 3", "Line 10 3", "Spline 20 9"], Center(Start + "L X+10\nDEP LCT X+20 Y+9 R3\n"));
    }

    [Theory]
    [InlineData("TOOL CALL 4 Z S2000 DR+0.5\n", 3.5)]
    [InlineData("TOOL CALL 4 Z S2000 DL+1 DR-0.25\n", 2.75)]
    [InlineData("TOOL CALL 4 Z DR+0.5\nTOOL CALL DR-0.5\n", 2.5)]
    [InlineData("TOOL CALL 4 Z DR+0.5\nTOOL CALL 4 Z\n", 3)]
    [InlineData("TOOL CALL S500\n", 3)]
    [InlineData("TOOL CALL 7 Z\n", 4)]
    [InlineData("TOOL CALL 7 Z DR+0.5\n", 4.5)]
    [InlineData("TOOL DEF 9 L+80 R+5\nTOOL CALL 9 Z DR+0.5\n", 5.5)]
    [InlineData("TOOL DEF 9\nTOOL CALL 9 Z\n", 3)]
    [InlineData("TOOL CALL \"MILL\" Z\n", 3)]
    public void The_radius_is_that_of_the_tool_and_its_oversize(string call, double radius)
    {
        var center = Follow(call + "L X-20 Y+0 Z-5 R0 FMAX\nL X+0 RL F100\nL X+10\n");
        Assert.Null(center.Refusal);
        Assert.Equal(radius, center.Motions[^1].End.Y, 9);
    }

    [Theory]
    [InlineData("TOOL CALL 4 Z DR+Q5\n")]
    [InlineData("TOOL CALL 4 Z DR2+0.5\n")]
    [InlineData("TOOL CALL 4 Z DR+0.5\nTOOL CALL S500\n")]
    [InlineData("TOOL DEF 9 L+0 R+Q3\nTOOL CALL 9 Z\n")]
    public void A_radius_that_only_the_machine_knows_is_not_guessed(string call) =>
        Assert.Equal("tool-radius-unknown", Refused(call + "L X-20 Y+0 Z-5 R0 FMAX\nL X+0 RL F100\nL X+10\n")?.Code);

    [Theory]
    [InlineData("L X+10\nL Y+6.1\nL X+0\n", null, 0)]
    [InlineData("L X+10\nL Y+5.9\nL X+0\n", "compensation-gouge", 7)]
    [InlineData("CR X+2.5 Y+2.5 R+2.5 DR+\nL Y+9\n", "compensation-gouge", 6)]
    [InlineData("L X+15\nRND R2\nL Y+9\n", "compensation-gouge", 6)]
    [InlineData("L X+10 RL\nL Y+10\n", null, 0)]
    [InlineData("L X+10 RR\n", "compensation-unfollowed", 6)]
    [InlineData("L X+10 M98\nL Y+10\n", "compensation-unfollowed", 6)]
    [InlineData("L X+10 M120 LA5\n", "compensation-unfollowed", 6)]
    [InlineData("TOOL CALL S300\nL X+10\n", null, 0)]
    [InlineData("TOOL CALL DR+0.1\nL X+10\n", "compensation-unfollowed", 6)]
    [InlineData("TOOL CALL 5 Z\nL X+10 Y+0 Z-5\n", "compensation-unfollowed", 6)]
    [InlineData("L X+10\nL Z+50 R0 FMAX\n", "compensation-unfollowed", 7)]
    [InlineData("L X+10\nCC X+10 Y+10\nC X+20 Y+10 DR+ R0\n", "compensation-entry", 8)]
    [InlineData("RND R5\nL Y+10\nL Y+20\n", "compensation-unfollowed", 5)]
    [InlineData("L X+10\nRND R2\nL Y-10 R0\n", "compensation-unfollowed", 6)]
    public void What_does_not_fit_or_is_not_known_is_refused_with_its_block(string contour, string? code, int line) =>
        Assert.Equal(code is null ? null : (code, line), Refused(Start + contour));

    [Fact]
    public void Compensation_begins_in_a_straight_block_only()
    {
        Assert.Equal(("compensation-entry", 6), Refused("CC X-20 Y+10\nC X-10 Y+10 DR+ RL\nL Y+20\n"));
        Assert.Equal(("compensation-unfollowed", 5), Refused("L X+0 RL M120 LA10\nL X+10\n"));
        Assert.Equal(("compensation-unfollowed", 5), Refused("APPR LT X-20 Y+0 LEN7 RL\nL X+10\n"));
    }

    [Fact]
    public void A_called_program_ends_compensation_in_a_way_that_is_not_followed()
    {
        var called = NcProgram.FromText("0 BEGIN PGM B MM\n1 L X+20\n2 END PGM B MM\n", NcSyntax.Klartext);
        var path = NcInterpreter.Run(
            NcProgram.FromText(Head + Start + "L X+10\nCALL PGM B\nL Y+10\nEND PGM A MM\n", NcSyntax.Klartext),
            NcDialects.HeidenhainKlartext.With(ToolRadii.Of(3)),
            name => name == "B" ? called : null,
            TestContext.Current.CancellationToken);
        Assert.Null(path.Refusal);
        Assert.Equal("compensation-unfollowed", CompensatedPath.Of(path, TestContext.Current.CancellationToken).Refusal?.Code);
    }

    [Fact]
    public void A_contour_is_not_displaced_to_where_the_tool_does_not_fit()
    {
        // A slot of 6.2 mm is made narrower than the tool from one side.
        var path = Read("L X+0 RL F100\nL X+10\nL Y+6.2\nL X+0\nL X-9 Y+9 R0\n");
        Assert.True(Displaced(path, 0.15).IsUsable);
        var refusal = Displaced(path, 0.25).Refusal;
        Assert.Equal(("compensation-gouge", 7), (refusal?.Code, refusal?.Place?.Line));
    }

    private static Refusals.Outcome<Rewrite> Displaced(NcPath path, double by) =>
        Rewriter.Apply(path, DisplacementWish.Normal(path, [7], by).Result!);

    private static IEnumerable<string> Center(string contour)
    {
        var center = Follow(contour);
        Assert.Null(center.Refusal);
        return center.Motions.Skip(2).Select(m => string.Create(
            CultureInfo.InvariantCulture, $"{m.Kind} {Math.Round(m.End.X, 4) + 0.0:0.####} {Math.Round(m.End.Y, 4) + 0.0:0.####}"));
    }

    private static (string Code, int Line)? Refused(string contour) =>
        Follow(contour).Refusal is { } refusal ? (refusal.Code, refusal.Place!.Line!.Value) : null;

    private static CompensatedPath Follow(string contour) => CompensatedPath.Of(Read(contour));

    private static NcPath Read(string contour) => NcInterpreter.Run(
        NcProgram.FromText(Head + contour + "END PGM A MM\n", NcSyntax.Klartext),
        NcDialects.HeidenhainKlartext.With(ToolRadii.OfTable(new Dictionary<int, double> { [7] = 4 }, 3)));
}
