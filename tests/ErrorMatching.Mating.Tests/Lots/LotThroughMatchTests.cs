using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Lots of counterparts, each corrected by a whole match of the one before it: what they cost against a filter that knows how
/// the process behaves.</summary>
public sealed class LotThroughMatchTests(ITestOutputHelper output)
{
    private static readonly int Lots = Depth.Of(1, 20);

    // A single lot may be unlucky.
    private static readonly double Luck = Lots == 1 ? 0.1 : 0;

    // A mean and a walk differ little from a drift: the gate leaves them out.
    public static TheoryData<string, double> Kinds
    {
        get
        {
            var all = new TheoryData<string, double>
            {
                { "drift", 1.15 }, { "step", 1.3 }, { "outliers", 1.15 }, { "noise", 1.05 },
            };
            if (Lots > 1)
            {
                all.Add("repeating", 1.15);
                all.Add("walk", 1.15);
            }

            return all;
        }
    }

    // The squares of what the pieces show, the noise included, as in the costs of the estimate alone.
    [Theory]
    [MemberData(nameof(Kinds))]
    public void The_squared_errors_are_near_those_of_a_filter_that_knows(string kind, double most)
    {
        AssertNear(
            kind,
            most,
            lot => Corrections(lot),
            lot => kind == "noise" ? new double[SimulatedLot.Pieces] : lot.ExpectedByTruth(),
            Depth.Of(1, 100));
    }

    // While one piece is measured, the next ones are cut with the program that there is.
    [Fact]
    public void Pieces_may_be_measured_late()
    {
        foreach (var delay in new[] { 2, 1, 3 }.Take(Depth.Of(1, 3)))
        {
            foreach (var kind in new[] { "repeating", "drift", "walk", "outliers", "step" }.Take(Depth.Of(1, 5)))
            {
                AssertNear(kind, kind == "step" ? 1.3 : 1.15, lot => Corrections(lot, delay), lot => lot.ExpectedByTruth(delay));
            }
        }
    }

    // Of every five pieces one is not measured; of every three one is measured twice: the gauge repeats to a third of what pieces scatter.
    [Fact]
    public void Pieces_may_be_left_out_and_measured_twice()
    {
        foreach (var kind in new[] { "repeating", "drift", "walk", "outliers" }.Take(Depth.Of(1, 4)))
        {
            AssertNear(
                kind, 1.15, lot => Corrections(lot, isMeasured: k => k % 5 != 4), lot => lot.ExpectedByTruth(isMeasured: k => k % 5 != 4));
            AssertNear(kind, 1.15, lot => Corrections(lot, isTwice: k => k % 3 == 0), lot => lot.ExpectedByTruth());
        }
    }

    private void AssertNear(
        string kind, double most, Func<SimulatedLot, double[]> corrections, Func<SimulatedLot, double[]> truth, int? lots = null)
    {
        var (cost, known) = (0.0, 0.0);
        foreach (var lot in SimulatedLot.Many(kind, lots ?? Lots))
        {
            cost += lot.Cost(corrections(lot));
            known += lot.Cost(truth(lot));
        }

        output.WriteLine($"{kind}: {cost / known:0.000} times the squares of the filter that knows");
        Assert.InRange(cost / known, 0.9, most + Luck);
    }

    // What the program corrects at each piece, in micrometers. The machine scatters from piece to piece, and so all points alike.
    private static double[] Corrections(
        SimulatedLot lot, int delay = 0, Func<int, bool>? isMeasured = null, Func<int, bool>? isTwice = null)
    {
        var series = new CounterpartSeries(SimulatedLot.U / 1000, delay: delay);
        var corrected = new double[SimulatedLot.Pieces];
        var random = new Random(1);
        for (var k = 0; k < corrected.Length; k++)
        {
            var at = series.NowMm;
            corrected[k] = -1000 * at;
            if (isMeasured?.Invoke(k) == false)
            {
                series.Skip();
                continue;
            }

            series.Measure(_ => (lot.Shown[k] / 1000) + at);
            if (isTwice?.Invoke(k) == true)
            {
                var off = (random.NextDouble() - 0.5) * SimulatedLot.U / 1000;
                series.Measure(_ => (lot.Shown[k] / 1000) + at + off, isAgain: true);
            }
        }

        return corrected;
    }
}
