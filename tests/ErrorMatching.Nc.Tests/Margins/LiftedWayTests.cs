using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Two cuts at one place, of which one is named, and what the proof says of the way between them. N2 goes from (0, 0) to
/// (10, 0), and N3 from there to (20, 10). N2 is displaced to y = 0.1, or the start of N3 by (0, 0.1).</summary>
public sealed class LiftedWayTests
{
    private const string Unnamed = "it moved although neither it nor a motion beside it was named.";
    private const string Way = "a move along the tool axis now moves in the plane or ends at another height.";

    // A tool that was lifted or changed began another cut, and that one stays.
    [Theory]
    [InlineData("G0 Z5.\nG1 Z-1.\n", "6 line 6: ", "7 N3: ")]
    [InlineData("G0 Z5.\nG0 Z1.\nG1 Z-1.\n", "7 line 7: ", "8 N3: ")]
    [InlineData("G1 Z1.\nG0 Z5.\nG1 Z1.\nG1 Z-1.\n", "8 line 8: ", "9 N3: ")]
    [InlineData("G1 Z1.\nT2 M6\nG1 Z-1.\n", "7 line 7: ", "8 N3: ")]
    [InlineData("T2 M6\nG1 Z-2.\n", "6 line 6: ", "7 N3: ")]
    [InlineData("G1 Z1.\nT2 M6\n", "5 line 5: ", "7 N3: ")]
    [InlineData("T2 M6\n", "6 N3: ")]
    public void A_cut_of_its_own_does_not_begin_elsewhere(string between, params string[] found) =>
        Assert.Equal(
            found.Select(f => f + Unnamed),
            Verdict.Found(Verdict.OnElements(Cuts("Y0.", "Y0.", between, ""), Cuts("Y0.1", "Y0.1", between, ""), ("N2", 0.1))));

    [Theory]
    [InlineData("G0 Z5.\nG1 Z-1.\n", "4 N2: ", "5 line 5: ")]
    [InlineData("G0 Z5.\nG0 Z1.\nG1 Z-1.\n", "4 N2: ", "5 line 5: ")]
    [InlineData("G1 Z1.\nG0 Z5.\nG1 Z1.\nG1 Z-1.\n", "4 N2: ", "5 line 5: ")]
    [InlineData("G1 Z1.\nT2 M6\nG1 Z-1.\n", "4 N2: ", "5 line 5: ")]
    [InlineData("T2 M6\nG1 Z-2.\n", "4 N2: ", "6 line 6: ")]
    [InlineData("G1 Z1.\nT2 M6\n", "4 N2: ", "5 line 5: ")]
    [InlineData("T2 M6\n", "4 N2: ")]
    public void A_cut_of_its_own_does_not_end_elsewhere(string between, params string[] found) =>
        Assert.Equal(found.Select(f => f + Unnamed), StartOfN3(Cuts("Y0.", "Y0.", between, ""), Cuts("Y0.", "Y0.1", between, "")));

    // It kept cutting: the other cut goes along. A tool change before N2 is none between the two.
    [Theory]
    [InlineData("")]
    [InlineData("G1 Z-2.\n")]
    [InlineData("G1 Z-2.\nG1 Z-3.\n")]
    public void A_cut_that_goes_on_goes_along(string between)
    {
        Assert.Empty(Verdict.OnElements(Cuts("Y0.", "Y0.", between, ""), Cuts("Y0.1", "Y0.1", between, ""), ("N2", 0.1)).Failures);
        Assert.Empty(StartOfN3(Cuts("Y0.", "Y0.", between, "T1 M6\n"), Cuts("Y0.", "Y0.1", between, "T1 M6\n")));
    }

    // One rapid with coordinates of its own leads from one place to the other.
    [Theory]
    [InlineData("G0 Z5.\nG0 X10. Y0.\nG1 Z-1.\n", "G0 Z5.\nG0 X10. Y0.1\nG1 Z-1.\n")]
    [InlineData("G0 Z5.\nG0 Z9.\nG0 Y0. Z2.\nG0 Z1.\nG1 Z-1.\n", "G0 Z5.\nG0 Z9.\nG0 Y0.1 Z2.\nG0 Z1.\nG1 Z-1.\n")]
    [InlineData("T2 M6\nG0 Y0. Z2.\nG1 Z-1.\n", "T2 M6\nG0 Y0.1 Z2.\nG1 Z-1.\n")]
    [InlineData("G0 Z5.\nG0 Y0. Z2.\nG1 Z-1.\n", "G0 Z5.\nG0 Y0.1 Z3.\nG1 Z-1.\n", "6 line 6: " + Way, "7 line 7: " + Way)]
    [InlineData("G0 Z5.\nG0 Y0.\nG1 Z-1.\n", "G0 Z5.\nG0 Y0.05\nG1 Y0.1 Z-1.\n", "6 line 6: " + Way, "7 line 7: " + Way)]
    [InlineData("G0 Z5.\nG0 Y0.\nG1 Z-1.\n", "G0 Y0.05 Z5.\nG0 Y0.1\nG1 Z-1.\n", "5 line 5: " + Way, "6 line 6: " + Way)]
    [InlineData("G0 Z5.\nG1 Y0. Z-1.\n", "G0 Z5.\nG1 Y0.1 Z-1.\n", "6 line 6: " + Way)]
    [InlineData("G0 Y0. Z5.\nG1 Z-1.\n", "G0 Y0.1 Z5.\nG1 Z-1.\n", "5 line 5: " + Way)]
    public void A_rapid_above_the_piece_leads_across(string between, string now, params string[] found) =>
        Assert.Equal(found, StartOfN3(Cuts("Y0.", "Y0.", between, ""), Cuts("Y0.", "Y0.", now, "")));

    // Nothing was cut before or behind it, so nothing holds it there.
    [Theory]
    [InlineData("G0 X10. Y0. Z5.\nG0 X10. Y0. Z2.\n", "G0 X10. Y0. Z5.\nG0 X10. Y0.1 Z2.\n", "3 line 3: " + Way)]
    [InlineData("G0 X10. Y0. Z5.\nG0 X10. Y0. Z2.\n", "G0 X10. Y0.1 Z5.\nG0 X10. Y0.1 Z2.\n")]
    public void An_approach_goes_along_as_a_whole(string approach, string now, params string[] found)
    {
        const string Rest = "G1 Z-1. F100\nN3 X20. Y10.\nG0 Z50.\n";
        Assert.Equal(found, StartOfN3("G90 G17\n" + approach + Rest, "G90 G17\n" + now + Rest));
    }

    [Theory]
    [InlineData("X10.", "G0 X10. Y0. Z9.\nG0 X50.\n", "6 line 6: " + Way)]
    [InlineData("X10.", "G0 X10. Y0. Z9.\n", "6 line 6: " + Way)]
    [InlineData("X0.", "G0 X0. Y0. Z9.\n", "6 line 6: " + Way)]
    public void A_retract_goes_along_as_a_whole(string end, string retract, params string[] found)
    {
        var before = $"G90 G17\nG0 X-5. Y0. Z0.\nG1 Z-1. F100\nN2 {end} Y0.\nG0 Z5.\n{retract}";
        var after = $"G90 G17\nG0 X-5. Y0.1 Z0.\nG1 Z-1. F100\nN2 {end} Y0.1\nG0 Z5.\n{retract}";

        Assert.Equal(found, Verdict.Found(Verdict.OnElements(before, after, ("N2", 0.1))));
    }

    // A rapid leads from the moved point back to where the cut begins.
    [Fact]
    public void A_point_above_the_piece_is_left_by_a_rapid()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z10.\nN10 G0 Z5.\nG0 X0. Y0. Z2.\nN3 G1 X10. Z0. F100\n";
        var after = Before.Replace("N10 G0 Z5.", "N10 G0 X0.1 Z5.", StringComparison.Ordinal);

        Assert.Empty(Verdict.OnEnds(Before, after, "N10", new(0.1, 0, 0)).Failures);
        Assert.Equal(
            ["5 N3: " + Unnamed],
            Verdict.Found(Verdict.OnEnds(
                Before, after.Replace("N3 G1 X10.", "N3 G1 X10.1", StringComparison.Ordinal), "N10", new(0.1, 0, 0))));
    }

    // What leads to a named point stays: only its own end moves.
    [Fact]
    public void A_plunge_to_a_named_point_begins_where_it_did()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z5.\nN10 G1 Z-1. F100\nN20 X10. Y0.\n";

        Assert.Equal(
            ["2 line 2: " + Unnamed, "3 N10: " + Unnamed],
            Verdict.Found(Verdict.OnEnds(
                Before, Before.Replace("X0. Y0. Z5.", "X0.1 Y0.2 Z5.", StringComparison.Ordinal), "N10", new(0.1, 0.2, 0))));
    }

    // Y is where the machine put it; X is carried along, so a rapid with X of its own leads back.
    [Fact]
    public void A_rapid_behind_a_machine_position_leads_back()
    {
        var path = Bench.Read(
            "G90 G17 G54\nG0 X0. Y0. Z0.\nN2 G1 X10. Y10. F100\nG0 Z5.\nG53 Y0.\nG0 X10. Z2.\nN3 G1 Y20.\n", NcDialects.FanucMill);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N2"), new(0.1, 0.2, 0)));
        var result = Bench.Text(path.Program).Replace("X10. Y10.", "X10.1 Y10.2", StringComparison.Ordinal);

        Assert.Empty(Prover.Check(path, NcProgram.FromText(result), wish, 0.001).Failures);
    }

    // Where N2 begins and ends, and what is between it and N3.
    private static string Cuts(string n2, string n3, string between, string before) =>
        $"G90 G17\nG0 X0. {n2} Z0.\nG1 Z-1. F100\n{before}N2 X10. {n3}\n{between}N3 G1 X20. Y10.\nG0 Z50.\n";

    private static string[] StartOfN3(string before, string after) =>
        Verdict.Found(Verdict.OnVectors(before, after, ("N3", new(0, 0.1), Vector2.Zero)));
}
