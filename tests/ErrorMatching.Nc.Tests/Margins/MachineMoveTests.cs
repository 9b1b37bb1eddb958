using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>A move to a place of the machine ends there, or goes along in the axes that it does not name. N2 ends at (10, 10) and moves by
/// (0.1, 0.2). The origin is that of the machine.</summary>
public sealed class MachineMoveTests
{
    private const string Ends = "a move to a place of the machine ends neither there nor where it comes from.";
    private const string Words = "it changed although its words alone do not say where it goes.";
    private const string Head = "G90 G17\nG10 L2 P1 X0. Y0. Z0.\nG54 G49\nG0 X0. Y0. Z0.\n";

    [Theory]
    [InlineData("G53 X20. Y20.", "G53 X20. Y20.", 0.22360679)]
    [InlineData("G53 Y20.", "G53 Y20.", 0.1)]
    [InlineData("G53 X20.", "G53 X20.", 0.2)]
    [InlineData("G53 Z20.", "G53 Z20.", 0.22360679)]
    [InlineData("G53 X20. Y20.", "G53 X20.05 Y20.", null, "7 line 7: " + Ends, "7 line 7: " + Words)]
    [InlineData("G53 X20. Y20.", "G53 X20. Y20.05", null, "7 line 7: " + Ends, "7 line 7: " + Words)]
    [InlineData("G53 X20. Z20.", "G53 X20. Z20.05", null, "7 line 7: " + Ends, "7 line 7: " + Words)]
    [InlineData("G53 X20. Y20.", "G53 X20.1 Y20.2", null, "7 line 7: " + Words)]
    public void It_ends_there_or_goes_along(string home, string now, double? displacement, params string[] found)
    {
        var before = Head + $"N2 G1 X10. Y10. F100\nG0 Z5.\n{home}\nG0 X50. Y50. Z9.\n";
        var after = Head + $"N2 G1 X10.1 Y10.2 F100\nG0 Z5.\n{now}\nG0 X50. Y50. Z9.\n";
        var path = Bench.Read(before, NcDialects.FanucMill);
        var motion = path.MotionOf(Bench.Blocks(path, "N2")[0]);
        var by = new Vector2(0.1, 0.2);
        DisplacementWish[] wishes =
        [
            DisplacementWish.OfEndPoints([motion], new(0.1, 0.2, 0)),
            DisplacementWish.OfElements([new(motion, by, by, by)]),
        ];
        foreach (var wish in wishes)
        {
            var isElement = wish.Elements.Count > 0;
            var result = isElement ? after.Replace("X0. Y0. Z0.\nN2", "X0.1 Y0.2 Z0.\nN2", StringComparison.Ordinal) : after;
            var proof = Prover.Check(path, NcProgram.FromText(result), wish, 0.001);

            Assert.Equal(found, Verdict.Found(proof));
            var neighbor = Assert.Single(proof.Neighbors, n => n.Line == 7);
            Assert.Equal(NeighborRole.Positioning, neighbor.Role);
            if (displacement is { } mm)
            {
                Assert.Equal(mm, neighbor.DisplacementMm, 1e-7);
            }
        }
    }

    // A control that feeds to a place of its own cuts on the way, but the place stays.
    [Fact]
    public void A_feed_to_a_machine_position_is_positioning()
    {
        const string Before = Head + "G0 X1. Y1.\nN1 G1 Z-1. F100\nN2 X10. Y10.\nG53 G1 X20. Y20.\nG0 Z9.\n";
        var path = Bench.Read(Before, NcDialects.LinuxCnc);
        var motion = path.MotionOf(Bench.Blocks(path, "N2")[0]);
        var by = new Vector2(0.1, 0.2);
        var result = Before.Replace("G0 X1. Y1.", "G0 X1.1 Y1.2", StringComparison.Ordinal)
            .Replace("X10. Y10.", "X10.1 Y10.2", StringComparison.Ordinal);
        var proof = Prover.Check(path, NcProgram.FromText(result), DisplacementWish.OfElements([new(motion, by, by, by)]), 0.001);

        Assert.Empty(proof.Failures);
        Assert.Equal(
            [("line 5", NeighborRole.Positioning), ("N1", NeighborRole.Positioning), ("line 8", NeighborRole.Positioning)],
            proof.Neighbors.Select(n => (n.Block, n.Role)));
    }
}
