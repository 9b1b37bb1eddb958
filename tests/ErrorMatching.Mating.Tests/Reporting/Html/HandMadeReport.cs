using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>A report whose numbers can be followed by hand: a horizontal line of 100 mm, its part 0.1 mm and 0.08 mm too far away, and a
/// short line within its tolerance.</summary>
internal static class HandMadeReport
{
    public static ReportFeature Line { get; } = new()
    {
        Name = "L1",
        Kind = LineKind.Instance,
        Tolerance = new(new(-0.02, 0.05), ToleranceSource.Stated),
        Quantities = [new(new("lengthMm", 100, 100.02, 0.003), 100.019), new(new("directionDeg", 0, -0.012, 0.0024), null)],
        Decision = Decision.Compensated,
        LargestMm = 0.1,
        UncertaintyMm = 0.0054,
        TheoreticalOutline = [new(0, 0), new(100, 0)],
    };

    public static ReportFeature Calm { get; } = Line with
    {
        Name = "L2",
        Decision = Decision.WithinTolerance,
        LargestMm = 0.01,
        Quantities = [],
        TheoreticalOutline = [],
    };

    public static MatchReport Report { get; } = new()
    {
        Job = new("Two lines", "WO-7", "jobs/two lines.json", new('a', 64)),
        Inputs = [
            new("theoretical", "theoretical.csv", new('b', 64)),
            new("part", "part.csv", new('c', 64)),
            new("program", "counterpart.nc", new('d', 64))],
        Alignments = [
            new(
                "part",
                JobAlignmentKind.BestFit,
                new(Mirror.None, Angle.FromDegrees(0.5), new(1, -2)),
                0.011,
                0.022,
                [new("1", new(0.003, -0.004))])],
        OriginCheck = new("O", 0.004, 0.01),
        Compensation = JobCompensation.Default,
        Uncertainty = new([new("probing", 0.003), new("clamping", 0.004)]),
        Chain = ReportChain.Of(new([new("housing", 17.5, new(-0.02, 0.03), 1), new("spacer", 5, new(-0.01, 0.01), -1)])),
        Features = [Line, Calm],
        KeyPoints =
        [
            Point("1", "L1", new(0, 0), 0.1, -0.0004, new(0, 0.1)),
            Point("2", "L1", new(100, 0), 0.08, -0.001, new(0, 0.08)),
            Point("3", "L2", new(200, 0), 0.01, -0.01, Vector2.Zero),
            Point("4", "L2", new(300, 0), 0, 0, Vector2.Zero),
        ],
        Program = new(
            "out/counterpart.nc",
            new('e', 64),
            1,
            2,
            [new("N10", 3, "N10 X-1.5 Y2.", "N10 X-1.5 Y2.1 F9", [new(11, 2), new(13, 0)], [new(11, 3), new(14, 3)])]),
        Proof = new(
            true,
            12,
            3,
            [new("N5", 2, NeighborRole.Slides, 0.0303), new("N15", 4, NeighborRole.Follows, 0.02)],
            "(ERRORMATCH)",
            0.0004,
            true),
        Time = new(3, 0.0123),
        RadiusWearMm = 0.02,
        Warnings = [new("gap", "Mind the gap.")],
        Notes = ["Nothing else."],
    };

    public static VerifyReport Verified { get; } = new(
        Report.Job,
        [.. Report.Inputs, new("counterpart", "before.csv", new('f', 64)), new("counterpart-after", "after.csv", new('0', 64))],
        new(
            [new("1", new(0, 0), new(0.3, -0.4), new(0, 0.05), new(0, 1)), new("2", new(50, 0), new(50, 0.1), new(50, 0), new(0, 1))],
            [
                new("L1", VerifiedQuantity.Length, 17.649, 17.308, 17.562),
                new("T1", VerifiedQuantity.Angle, 60, 60, 60),
                new("L1", VerifiedQuantity.Deviation, 0, 0.4, 0.05)]),
        ["Mind the gap."]);

    private static ReportKeyPoint Point(
        string label, string feature, Point2 theoretical, double normal, double predicted, Vector2 correction) =>
        new()
        {
            Point = label,
            Feature = feature,
            Theoretical = theoretical,
            Actual = theoretical + new Vector2(0.002, normal),
            Normal = new(0, 1),
            Correction = correction,
            DecidedMm = normal,
            UncompensatedMm = -normal,
            ExcessMm = Line.Tolerance.Band.ExcessOf(normal),
            PredictedMm = predicted,
            Blocks = ["N10"],
        };
}
