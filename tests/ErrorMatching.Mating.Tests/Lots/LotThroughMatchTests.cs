using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Lots of counterparts, each corrected by a whole match of the one before it: what they cost against a filter that knows how
/// the process behaves.</summary>
public sealed class LotThroughMatchTests(ITestOutputHelper output)
{
    private static readonly int Lots = Depth.Of(1, 20);

    // A single lot may be unlucky.
    private static readonly double Luck = Lots == 1 ? 0.1 : 0;

    // The squares of what the pieces show, the noise included, as in the costs of the estimate alone.
    [Theory]
    [InlineData("repeating", 1.15)]
    [InlineData("drift", 1.15)]
    [InlineData("walk", 1.15)]
    [InlineData("step", 1.3)]
    [InlineData("outliers", 1.15)]
    [InlineData("noise", 1.05)]
    public void The_squared_errors_are_near_those_of_a_filter_that_knows(string kind, double most)
    {
        var (cost, known) = (0.0, 0.0);
        foreach (var lot in SimulatedLot.Many(kind, Lots))
        {
            cost += lot.Cost(Corrections(lot));
            known += lot.Cost(kind == "noise" ? new double[SimulatedLot.Pieces] : lot.ExpectedByTruth());
        }

        output.WriteLine($"{kind}: {cost / known:0.000} times the squares of the filter that knows");
        Assert.InRange(cost / known, 0.9, most + Luck);
    }

    // What the program corrects at each piece, in micrometers. The machine scatters from piece to piece, and so all points alike.
    private static double[] Corrections(SimulatedLot lot)
    {
        var series = new CounterpartSeries(SimulatedLot.U / 1000);
        var corrected = new double[SimulatedLot.Pieces];
        for (var k = 0; k < corrected.Length; k++)
        {
            corrected[k] = -1000 * series.NowMm;
            series.Measure(_ => (lot.Shown[k] / 1000) + series.NowMm);
        }

        return corrected;
    }
}
