using ErrorMatching.Testing;

namespace ErrorMatching.Measurement.Tests;

/// <summary>What it costs not to know how a process behaves, against a filter that knows.</summary>
public sealed class LotCostTests
{
    [Theory]
    [InlineData("repeating")]
    [InlineData("drift")]
    [InlineData("walk")]
    [InlineData("step")]
    [InlineData("outliers")]
    public void The_squared_errors_are_at_most_a_tenth_more_than_with_the_truth(string kind)
    {
        var (cost, known) = Costs(kind, lot => lot.ExpectedByTruth());

        Assert.InRange(cost / known, 1.0, 1.10);
    }

    [Fact]
    public void Pure_noise_is_left_alone()
    {
        var (cost, nothing) = Costs("noise", _ => new double[SimulatedLot.Pieces]);

        Assert.InRange(cost / nothing, 0.99, 1.02);
    }

    [Fact]
    public void A_step_of_10_um_is_found_within_three_pieces()
    {
        var lots = SimulatedLot.Many("step", 20).ToArray();

        var found = lots.Count(lot =>
        {
            var filter = New();
            foreach (var shown in lot.Shown.Take(lot.StepAt + 3))
            {
                filter.Add([shown]);
            }

            return Enumerable.Range(lot.StepAt - 1, 4).Sum(k => filter.Probability(k, LotEvent.Step)) > 0.5;
        });

        Assert.InRange(found, 18, 20);
    }

    [Fact]
    public void Outliers_are_found_and_nothing_else_is_taken_for_one()
    {
        var (found, wrong, all) = (0, 0, 0);
        foreach (var lot in SimulatedLot.Many("outliers", 10))
        {
            var filter = New();
            Array.ForEach(lot.Shown, shown => filter.Add([shown]));
            for (var k = 0; k < SimulatedLot.Pieces; k++)
            {
                var isFound = filter.Probability(k, LotEvent.Outlier) > 0.5;
                all += lot.IsOutlier[k] ? 1 : 0;
                found += isFound && lot.IsOutlier[k] ? 1 : 0;
                wrong += isFound && !lot.IsOutlier[k] ? 1 : 0;
            }
        }

        Assert.True(all > 10);
        Assert.Equal(all, found);
        Assert.InRange(wrong, 0, 2);
    }

    private static (double Cost, double Other) Costs(string kind, Func<SimulatedLot, double[]> other)
    {
        var (cost, sum) = (0.0, 0.0);
        foreach (var lot in SimulatedLot.Many(kind, 20))
        {
            var (filter, expected) = (New(), new double[SimulatedLot.Pieces]);
            for (var k = 0; k < expected.Length; k++)
            {
                expected[k] = filter.Expected[0];
                filter.Add([lot.Shown[k]]);
            }

            cost += lot.Cost(expected);
            sum += lot.Cost(other(lot));
        }

        return (cost, sum);
    }

    private static LotFilter New() => new(1, 1, SimulatedLot.U, SimulatedLot.U * SimulatedLot.U);
}
