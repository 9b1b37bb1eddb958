using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Surfaces cut and measured piece by piece, each by the program that the piece before it led to.</summary>
public sealed class SurfaceLotTests
{
    private const string Finished = "\"measuredAfter\": \"finishing\"";
    private const double NoiseMm = 0.001;

    private static readonly Func<double, double, double> _bowl = (u, v) => 0.004 + (0.012 * u * u) - (0.01 * v * (1 - v));

    [Fact]
    public void What_is_left_falls_with_every_piece()
    {
        var (first, fifth) = (0.0, 0.0);
        for (var seed = 0; seed < 3; seed++)
        {
            var made = Cut(5, _ => _bowl, seed);
            first += Left(made[0], _bowl);
            fifth += Left(made[4], _bowl);
        }

        // Five measurements say more than one: at best 1 / sqrt(5) of the error is left.
        Assert.InRange(fifth / first, 0.4, 0.75);
    }

    [Fact]
    public void A_new_tool_is_followed_and_reported()
    {
        var made = Cut(8, k => k < 5 ? _bowl : (u, v) => _bowl(u, v) + 0.008, 3);

        Assert.True(Left(made[7], (u, v) => _bowl(u, v) + 0.008) < 0.0012);
        Assert.Equal(LotEvent.Step, made[7].Lot!.Pieces[5].Event);
        Assert.Contains(
            made[5].Warnings.Concat(made[6].Warnings),
            w => w is { Code: "lot-step", Values: ["6", ..] });
    }

    [Fact]
    public void A_piece_that_does_not_fit_hardly_counts()
    {
        var made = Cut(6, k => k == 4 ? (u, v) => _bowl(u, v) - 0.03 : _bowl, 5);

        Assert.Equal(LotEvent.Outlier, made[4].Lot!.Pieces[4].Event);
        Assert.Contains(made[4].Warnings, w => (w.Code, w.Values[0]) == ("lot-outlier", "4"));
        Assert.True(Left(made[4], _bowl) < 0.002);

        // While it may still be a new tool, the prediction is not sure of itself.
        Assert.True(made[4].Mirror.PointUncertaintyMm > 2 * made[3].Mirror.PointUncertaintyMm);
        Assert.True(Left(made[5], _bowl) < 0.001);
    }

    [Fact]
    public void A_report_carries_the_lot_to_the_next_compensation()
    {
        var design = new MeasuredDesign(PaperDesign.One, "\"measuredAfter\": \"semi-finishing\"", Finished);
        var noise = new Noise(1);
        var first = design.Compensate(design.With((u, v) => _bowl(u, v) + (NoiseMm * noise.Next()))).Result!;
        var measured = design.With((u, v) => _bowl(u, v) - first.Compensated.At(u, v) + (NoiseMm * noise.Next()), "second.csv");

        var direct = Next(design, first.Pieces, measured).Result!;
        var read = Next(design, Stored(first.Pieces, null), measured).Result!;

        Assert.All(direct.Pieces.CorrectionsMm.Zip(read.Pieces.CorrectionsMm), p => Assert.Equal(p.First, p.Second, 1e-8));
        Assert.Equal(2, read.Pieces.Pieces.Count);
        Assert.Equal(first.Pieces.CorrectionsMm, direct.Pieces.Pieces[1].Values.CorrectionsMm);
    }

    [Fact]
    public void A_piece_with_stock_was_not_cut_by_the_program_before()
    {
        var design = new MeasuredDesign(PaperDesign.One);
        var noise = new Noise(2);
        var first = design.Compensate(design.With((u, v) => _bowl(u, v) + (NoiseMm * noise.Next()))).Result!;

        var second = Next(design, first.Pieces, design.With((u, v) => _bowl(u, v) + (NoiseMm * noise.Next()), "second.csv")).Result!;

        Assert.All(second.Pieces.Pieces[1].Values.CorrectionsMm, c => Assert.Equal(0, c));
        Assert.True(Left(second, _bowl) < 0.001);
    }

    [Fact]
    public void A_change_beyond_the_limit_of_a_step_is_refused()
    {
        var (first, measured) = Pair(NewLimit("0.2"));
        var largest = Next(NewLimit("0.2"), first, measured).Result!.Pieces.CorrectionsMm
            .Zip(first.CorrectionsMm, (now, was) => Math.Abs(now - was)).Max();

        var inside = Next(NewLimit((largest + 1e-9).ToString("R", CultureInfo.InvariantCulture)), first, measured);
        var beyond = Next(NewLimit((largest - 1e-9).ToString("R", CultureInfo.InvariantCulture)), first, measured);

        Assert.True(inside.IsUsable);
        Assert.Equal("beyond-step", beyond.Refusal!.Code);
    }

    [Fact]
    public void Other_points_and_the_same_measurement_are_refused()
    {
        var design = NewLimit("0.2");
        var (first, measured) = Pair(design);

        Assert.Equal("other-points", Code(first with { Points = [.. first.Points.SkipLast(1)] }));
        Assert.Equal("other-points", Code(first with { Points = [.. first.Points, "1000"] }));
        Assert.Equal("other-points", Code(first with { Points = [.. first.Points.Reverse()] }));
        Assert.Equal(
            "same-measurement",
            Code(first with { Pieces = [first.Pieces[0] with { MeasuredSha256 = MeasuredPoints.Sha256Of([measured]) }] }));

        string Code(MeasuredLot lot) => Next(design, lot, measured).Refusal!.Code;
    }

    [Fact]
    public void Only_the_latest_pieces_are_kept()
    {
        var design = NewLimit("0.2");
        var (first, measured) = Pair(design);
        var lot = first with { Pieces = [.. Enumerable.Repeat(first.Pieces[0], MeasuredLot.MostPieces)] };

        var next = Next(design, lot, measured).Result!.Pieces;

        Assert.Equal(MeasuredLot.MostPieces, next.Pieces.Count);
        Assert.Equal(MeasuredPoints.Sha256Of([measured]), next.Pieces[^1].MeasuredSha256);
    }

    [Fact]
    public void Several_pieces_of_one_program_compensate_together()
    {
        var design = new MeasuredDesign(PaperDesign.One);
        var (alone, together) = (0.0, 0.0);
        for (var seed = 0; seed < 2; seed++)
        {
            var noise = new Noise(20 + seed);
            MeasuredPoints[] pieces = [
                .. Enumerable.Range(0, 5).Select(k => design.With((u, v) => _bowl(u, v) + (NoiseMm * noise.Next()), $"piece{k}.csv"))];
            var result = Compensator.Compensate(
                new(design.Job, design.Surface, design.Plan, [pieces[4]]) { Earlier = [.. pieces[..4].Select(p => new[] { p })] }).Result!;
            Assert.Equal(5, result.Pieces.Pieces.Count);
            alone += Left(design.Compensate(pieces[4]).Result!, _bowl);
            together += Left(result, _bowl);
        }

        Assert.InRange(together / alone, 0.2, 0.75);
        var one = design.With(_bowl);
        Assert.Equal("same-measurement", Assert.Throws<InputException>(() => Compensator.Compensate(
            new(design.Job, design.Surface, design.Plan, [one]) { Earlier = [[one]] })).Code);
    }

    private static MeasuredDesign NewLimit(string mm) =>
        new(PaperDesign.One, "\"limitMm\": 0.2", $"\"limitMm\": 0.2, \"stepLimitMm\": {mm}");

    // The first piece of a design, and a measurement of the second.
    private static (MeasuredLot First, MeasuredPoints Measured) Pair(MeasuredDesign design)
    {
        var noise = new Noise(4);
        var first = design.Compensate(design.With((u, v) => _bowl(u, v) + (NoiseMm * noise.Next()))).Result!;
        return (first.Pieces, design.With((u, v) => _bowl(u, v) + 0.005 + (NoiseMm * noise.Next()), "second.csv"));
    }

    private static List<CompensationResult> Cut(int pieces, Func<int, Func<double, double, double>> process, int seed)
    {
        var design = new MeasuredDesign(PaperDesign.One, "\"measuredAfter\": \"semi-finishing\"", Finished);
        var noise = new Noise(seed);
        var made = new List<CompensationResult>();
        for (var k = 0; k < pieces; k++)
        {
            var (error, before) = (process(k), made.LastOrDefault());
            var measured = design.With(
                (u, v) => error(u, v) - (before?.Compensated.At(u, v) ?? 0) + (NoiseMm * noise.Next()),
                $"piece{k}.csv");
            made.Add(Next(design, before?.Pieces, measured).Result!);
        }

        return made;
    }

    private static Outcome<CompensationResult> Next(MeasuredDesign design, MeasuredLot? previous, MeasuredPoints measured) =>
        Compensator.Compensate(new(design.Job, design.Surface, design.Plan, [measured]) { Previous = previous });

    // The root mean square of the true error that the next piece will have.
    private static double Left(CompensationResult result, Func<double, double, double> truth)
    {
        var sum = 0.0;
        for (var i = 0; i <= 20; i++)
        {
            for (var j = 0; j <= 20; j++)
            {
                var left = truth(i / 20.0, j / 20.0) - result.Compensated.At(i / 20.0, j / 20.0);
                sum += left * left / 441;
            }
        }

        return Math.Sqrt(sum);
    }

    private static MeasuredLot Stored(MeasuredLot lot, Lot? state) => LotJson.Read(ReportReader.Document(
        ReportWriter.Document("errormatch/test/1", json => json.Object("lot", () => LotJson.Write(json, lot, state))))).Pieces!;
}
