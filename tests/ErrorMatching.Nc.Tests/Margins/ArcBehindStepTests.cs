namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The quarter N20 of radius 10 about the origin, from (10, 0) to (0, 10) or back. Its end at (10, 0) moves by (0, 0.1), nearly along the
/// circle. If the line N10 moved it directly, the arc slides and keeps its center. Behind a step in depth it follows: its middle moves by
/// half of that, so it goes through (10, 0.1), (7.0711, 7.1211) and (0, 10), about (0.0849, 0.0852).
/// </summary>
public sealed class ArcBehindStepTests
{
    private const string Slid = "its ends slid along its circle, but its center moved.";
    private const string Follows = "I-9.9151 J-0.0148";
    private const string Slides = "I-10. J-0.1";

    [Theory]
    [InlineData("G1 Z-1.\n", Follows, NeighborRole.Follows)]
    [InlineData("G1 Z-1.\nG1 Z-2.\n", Follows, NeighborRole.Follows)]
    [InlineData("G1 Z-1.\n", Slides, NeighborRole.Slides)]
    [InlineData("", Slides, NeighborRole.Slides)]
    [InlineData("", Follows, NeighborRole.Follows, "N20: " + Slid)]
    public void Its_start_moves(string between, string center, NeighborRole role, params string[] found)
    {
        var before = $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n{between}N20 G3 X0. Y10. I-10. J0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.3 Z0.\nN10 G1 X10. Y0.1 F100\n{between}N20 G3 X0. Y10. {center}\nG0 Z5.\n";
        var proof = Verdict.OnVectors(before, after, ("N10", new(0, 0.3), new(0, 0.1)));

        Assert.Equal(found, proof.Failures.Select(f => f.Message));
        Assert.Equal(role, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    [Theory]
    [InlineData("G1 Z-1.\n", "I0.0849 J-9.9148", NeighborRole.Follows)]
    [InlineData("G1 Z-1.\nG1 Z-2.\n", "I0.0849 J-9.9148", NeighborRole.Follows)]
    [InlineData("G1 Z-1.\n", "I0. J-10.", NeighborRole.Slides)]
    [InlineData("", "I0. J-10.", NeighborRole.Slides)]
    [InlineData("", "I0.0849 J-9.9148", NeighborRole.Follows, "N20: " + Slid)]
    public void Its_end_moves(string between, string center, NeighborRole role, params string[] found)
    {
        var before = $"G90 G17\nG0 X0. Y10. Z0.\nN20 G2 X10. Y0. I0. J-10. F100\n{between}N10 G1 X20. Y0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y10. Z0.\nN20 G2 X10. Y0.1 {center} F100\n{between}N10 G1 X20. Y0.3\nG0 Z5.\n";
        var proof = Verdict.OnVectors(before, after, ("N10", new(0, 0.1), new(0, 0.3)));

        Assert.Equal(found, proof.Failures.Select(f => f.Message));
        Assert.Equal(role, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // An end that is an increment from where the wish puts it took the wish. Two increments from there, it did not.
    [Theory]
    [InlineData("X10.001", "I-9.916 J-0.0156")]
    [InlineData(
        "X9.998",
        "I-9.9133 J-0.0131",
        "3 N10: an end moved by (-0.002, 0.100), where neither the wish nor a neighbor puts it.",
        "5 N20: " + Slid)]
    public void An_end_took_the_wish_to_an_increment(string end, string center, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG1 Z-1.\nN20 G3 X0. Y10. I-10. J0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {end} Y0.1 F100\nG1 Z-1.\nN20 G3 X0. Y10. {center}\nG0 Z5.\n";

        Assert.Equal(found, Verdict.Found(Verdict.OnElements(Before, after, ("N10", 0.1))));
    }

    // The ring closes where N40 ends, and nothing but a retract comes behind it. This quarter is the other one from the left.
    [Theory]
    [InlineData("I0. J-10.")]
    [InlineData("I-0.0849 J-9.9148", "N40: " + Slid)]
    public void The_last_arc_of_a_ring_keeps_its_center(string center, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN40 G3 X0. Y0. I0. J-10.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nN20 X10. Y10.\nN40 G3 X0. Y0.1 {center}\nG0 Z5.\n";

        Assert.Equal(found, Verdict.OnElements(Before, after, ("N10", 0.1)).Failures.Select(f => f.Message));
    }
}
