using ErrorMatching.Cell;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a kept report says of a piece, without a station.</summary>
public sealed class StoredPieceTests
{
    private static readonly Correction Part = new(
        1, CorrectionState.Proposed, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1)
    {
        Piece = "part"
    };

    [Fact]
    public void What_is_not_compensated_is_expected_to_stay_as_it_is()
    {
        // Wide limits: nothing is compensated, so both assemblies are the same.
        var report = SampleReport.Of(j => j.Replace("[-0.05, 0.05]", "[-0.5, 0.5]", StringComparison.Ordinal));
        var piece = StoredPiece.Predicted(Part, report);
        Assert.All(report.Features, f => Assert.Equal(Decision.WithinTolerance, f.Decision));
        Assert.All(piece.Result.Points, p => Assert.Equal(p.BeforeError.NormalMm, p.AfterError.NormalMm, 9));
        Assert.All(piece.Result.Features, f => Assert.Equal(0, f.ImprovementPercent!.Value, 6));
        Assert.True(piece.IsWithin);
        var detail = new PieceDetail(piece, [piece]);
        Assert.Equal(
            ("Every point is within its limits.", "Cut the counterpart and measure it: until then this is a prediction."),
            (detail.Verdict, detail.ToDo));

        var (before, after) = (GapDrawing.Before(piece), GapDrawing.After(piece));
        Assert.All(
            before.Counterpart.Zip(after.Counterpart),
            lines => Assert.All(lines.First.Zip(lines.Second), p => Assert.True(p.First.DistanceTo(p.Second) < 1e-6)));

        // And the counterpart is the outline that the program cuts; it stands upright, and is drawn lying.
        Assert.True(after.IsLong && after.IsTurned);
        Assert.All(
            report.Features.Zip(after.Counterpart),
            f => Assert.All(f.First.TheoreticalOutline, p => Assert.Contains(f.Second, c => new Point2(p.Y, -p.X).DistanceTo(c) < 1e-6)));
    }

    [Fact]
    public void Where_the_part_lies_further_out_a_gap_is_drawn_and_it_closes()
    {
        var piece = StoredPiece.Predicted(Part, SampleReport.Of(j => j));
        var (before, after) = (GapDrawing.Before(piece), GapDrawing.After(piece));

        // Point 1 of the part lies 0.117 mm further out along the normal, which the counterpart follows.
        var point = piece.Result.Points.Single(p => p.Label == "1");
        Assert.Equal(-0.117, point.BeforeError.NormalMm, 0.0005);
        Assert.Equal(0.117, before.Points.Single(p => p.Label == "1").GapMm, 0.0005);
        Assert.Equal(0, after.Points.Single(p => p.Label == "1").GapMm, 0.001);
        Assert.True(after.LargestMm < before.LargestMm);
        Assert.Equal((before.Factor, before.Extent), (after.Factor, after.Extent));

        // What is said to be the most is seen, also at a point on a corner, beside both lines.
        Assert.All(new[] { before, after }, d =>
        {
            Assert.Equal(d.LargestMm, d.Points.Max(p => p.At.DistanceTo(p.Opposite)) / d.Factor, 1e-9);

            // Point 1 lies on a straight of two corners, far from either: the lines are where it is.
            var first = d.Points.Single(p => p.Label == "1");
            Assert.Contains(d.Part[0], p => p.DistanceTo(first.At) < 0.02 * d.Factor);
            Assert.Contains(d.Counterpart[0], p => p.DistanceTo(first.Opposite) < 0.02 * d.Factor);
            Assert.All(d.Points, p => Assert.Equal(Math.Abs(p.GapMm), p.At.DistanceTo(p.Opposite) / d.Factor, 1e-9));
            Assert.All(
                d.Points.SelectMany(p => new[] { p.At, p.Opposite }).Concat(d.Part.Concat(d.Counterpart).SelectMany(l => l)),
                p => Assert.True(d.Extent.Contains(p)));
        });

        // What is said under the finger is not turned with the drawing, and neither are the limits of 0.05 mm.
        Assert.Equal(
            piece.Result.Points.Select(p => (p.Label, -p.AfterError.NormalMm, Math.Abs(p.AfterError.NormalMm) > 0.05)),
            after.Points.OrderBy(
                p => piece.Result.Points.ToList().FindIndex(r => r.Label == p.Label)).Select(p => (p.Label, p.GapMm, p.IsOutside)));
        Assert.True(
            after.Points.Max(p => p.At.X) - after.Points.Min(p => p.At.X) > 5 * (
                after.Points.Max(p => p.At.Y) - after.Points.Min(p => p.At.Y)));
        Assert.EndsWith(" Turned by 90°.", after.Note, StringComparison.Ordinal);
    }

    [Fact]
    public void A_mating_error_is_held_against_the_limits_the_other_way_round()
    {
        // The part may lie far in and not out: an overlap may be large, a gap not.
        var piece = StoredPiece.Predicted(
            Part, SampleReport.Of(j => j.Replace("[-0.05, 0.05]", "[-0.5, 0.001]", StringComparison.Ordinal)));
        var band = piece.Result.BandOf("9")!;
        Assert.Equal((-0.001, 0.5), (band.LowerMm, band.UpperMm));
        Assert.Equal("C1", piece.Result.BoundaryOf("9")!.Name);
        Assert.Null(piece.Result.BandOf("nobody"));
    }

    // The paper's counterpart: 0.35 mm with compensation, 0.51 mm without; of the one as designed it would be 0.14 mm.
    [Fact]
    public void A_measured_counterpart_is_not_called_better_or_worse_than_one_that_nobody_cut()
    {
        Texts.Current.Language = Language.English;
        var predicted = StoredPiece.Predicted(Part, SampleReport.Of());
        Assert.StartsWith("Expected to be better by ", new PieceDetail(predicted, [predicted]).Summary, StringComparison.Ordinal);
        var result = predicted.Result;
        var measured = predicted with
        {
            Counterpart = Part with { Id = 2 },
            Result = result with { Points = [.. result.Points.Select(p => p with { Before = p.After, After = p.Before })] },
        };

        var detail = new PieceDetail(measured, [measured]);
        Assert.False(measured.TellsImprovement);
        Assert.StartsWith("Against the counterpart as designed", detail.Summary, StringComparison.Ordinal);
        Assert.False(detail.IsWorse);
        Assert.All(detail.Features, f => Assert.Equal((Shown.Nothing, false), (f.Improvement, f.IsWorse)));

        var known = measured with { IsBeforeMeasured = true };
        Assert.True(new PieceDetail(known, [known]).IsWorse);
    }

    [Fact]
    public void Where_points_stay_outside_as_predicted_a_person_decides_about_the_piece_and_can_change_the_set_up()
    {
        var match = SampleReport.Of().Leaving(("2", 0.06), ("4", -0.07));
        var predicted = StoredPiece.Predicted(Part, match);
        var before = new PieceDetail(predicted, [predicted]);
        Assert.Equal("2 points outside their limits: 2, 4. Within limits without compensation: 2, 4.", before.Verdict);
        Assert.Equal("Before cutting, read the warnings of the correction: 2, 4 will stay outside.", before.ToDo);
        var measured = predicted with { Counterpart = Part with { Id = 2 } };
        Assert.Equal(["2", "4"], measured.Outside);
        Assert.Equal(
            "Someone must decide whether to use this piece; the station does not. It was cut as predicted. Before the next one, "
                + "choose points in the set-up other than 2, 4, which are on corners, or change their limits.",
            new PieceDetail(measured, [measured]).ToDo);

        // Where no warning says why, nothing is said of corners.
        var unwarned = measured with { Match = match with { Warnings = [] } };
        Assert.Equal(
            "Someone must decide whether to use this piece; the station does not. It was cut as predicted. Before the next one, change "
                + "the limits of 2, 4 in the set-up, or read in the warnings why the compensation does not reach there.",
            new PieceDetail(unwarned, [unwarned]).ToDo);

        // The warning itself asks for nothing that cannot be done any more.
        Assert.All(
            match.Warnings,
            w => Assert.EndsWith(
                " For the next pieces, choose a point further from the corner in the set-up.",
                WarningText.Of(w),
                StringComparison.Ordinal));
    }
}
