using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Freeform.Tests;

public sealed class SpatialStructureTests
{
    [Fact]
    public void Four_places_in_a_row_worked_by_hand()
    {
        // Values 1 2 4 5, mean 3, z = -2 -1 1 2; neighbors 1-2, 2-3, 3-4: sum of z z over pairs 2 - 1 + 2 = 3, doubled 6;
        // sum of squares 10, W = 6. I = 4 / 6 * 6 / 10 = 0.4. E = -1/3.
        // S0 = 6, S1 = 12, S2 = 4 (1 + 4 + 4 + 1) = 40, b2 = 4 * 34 / 100 = 1.36. E[I^2] = (4 ((16 - 12 + 3) 12 - 4 * 40 + 3 * 36) - 1.36
        // ((16 - 4) 12 - 8 * 40 + 6 * 36)) / (3 * 2 * 1 * 36) = (4 * 32 - 1.36 * 40) / 216 = 73.6 / 216.
        var result = SpatialStructure.Test([1, 2, 4, 5], [(0, 1), (1, 2), (2, 3)]);

        Assert.Equal(0.4, result.I, 1e-14);
        Assert.Equal(-1.0 / 3, result.Expectation, 1e-14);
        Assert.Equal((73.6 / 216) - (1.0 / 9), result.Variance, 1e-14);
    }

    [Fact]
    public void Expectation_and_variance_are_those_of_all_orders_of_the_values()
    {
        double[] values = [0.3, 1.9, -2.2, 4.1, 0.7, 8.0];
        (int, int)[] neighbors = [(0, 1), (1, 2), (3, 4), (4, 5), (0, 3), (1, 4), (2, 5)];
        var all = Orders(values).Select(order => BruteForce(order, neighbors)).ToArray();
        var result = SpatialStructure.Test(values, neighbors);

        Assert.Equal(720, all.Length);
        Assert.Equal(BruteForce(values, neighbors), result.I, 1e-13);
        Assert.Equal(all.Average(), result.Expectation, 1e-13);
        Assert.Equal(all.Average(i => i * i) - (all.Average() * all.Average()), result.Variance, 1e-13);
    }

    [Fact]
    public void A_smooth_error_is_systematic_and_noise_is_noise()
    {
        Assert.Equal(SpatialVerdict.Systematic, SpatialStructure.Test(TrueShape.MachineError.Samples(noise: 0.001)).Verdict);
        var flat = new TrueShape("flat", (x, y) => 0.015);
        var wrong = Enumerable.Range(1, 200).Count(
            seed => SpatialStructure.Test(flat.Samples(noise: 0.003, seed: seed)).Verdict == SpatialVerdict.Systematic);

        // 5 % of 200 are 10, with a standard deviation of 3.
        Assert.InRange(wrong, 2, 20);
    }

    [Fact]
    public void What_a_field_leaves_of_a_smooth_error_is_noise()
    {
        var samples = TrueShape.MachineError.Samples(noise: 0.001, seed: 2);

        Assert.Equal(SpatialVerdict.Noise, SpatialStructure.Test(samples, FieldFit.Fit(samples).Residuals).Verdict);
    }

    [Fact]
    public void Values_that_are_alike_or_too_few_say_nothing()
    {
        Assert.Equal(SpatialVerdict.Undetermined, SpatialStructure.Test(new TrueShape("flat", (x, y) => 1).Samples()).Verdict);
        Assert.Equal(SpatialVerdict.Undetermined, SpatialStructure.Test(TrueShape.MachineError.Samples(3, 3)).Verdict);
        Assert.Equal(SpatialVerdict.Undetermined, SpatialStructure.Test([]).Verdict);
        Assert.Throws<ArgumentException>(() => SpatialStructure.Test(TrueShape.MachineError.Samples(), [1.0]));
    }

    [Fact]
    public void Neighbors_on_a_rectangular_grid_are_those_beside_before_and_behind()
    {
        var samples = TrueShape.MachineError.Samples(4, 3);
        FieldData data = new(
            [.. samples.Select(s => s.I)],
            [.. samples.Select(s => s.J)],
            [.. samples.Select(s => s.U)],
            [.. samples.Select(s => s.V)],
            [.. samples.Select(s => s.ErrorMm)]);

        // 3 curves of 3 pairs each, and 2 times 4 across.
        Assert.Equal(17, SpatialStructure.Neighbors(data).Count);
        Assert.Contains((1, 5), SpatialStructure.Neighbors(data));
    }

    [Fact]
    public void Structure_does_not_depend_on_unit_or_origin() => Prop.ForAll(
        ArbMap.Default.ArbFor<int>().Filter(seed => seed is > 0 and < 100_000),
        seed =>
        {
            var samples = TrueShape.MachineError.Samples(5, 4, 0.002, seed);
            var (one, other) = (
                SpatialStructure.Test(samples), SpatialStructure.Test(samples, [.. samples.Select(s => (1000 * s.ErrorMm) - 7)]));
            return Math.Abs(one.I - other.I) < 1e-9 && Math.Abs(one.Z - other.Z) < 1e-8;
        }).QuickCheckThrowOnFailure();

    [Theory]
    [InlineData(0, 0.5)]
    [InlineData(1.6448536269514722, 0.05)]
    [InlineData(-1.2815515655446004, 0.9)]
    [InlineData(4.7534243088228987, 1e-6)]
    public void Tail_of_the_normal_distribution_is_that_of_the_tables(double x, double tail) =>
        Assert.Equal(tail, SpatialStructure.NormalTail(x), tail * 1e-9);

    /// <summary>Moran's I by its definition, over all pairs of places.</summary>
    private static double BruteForce(double[] values, (int A, int B)[] neighbors)
    {
        var (cross, squares, weights, mean) = (0.0, 0.0, 0.0, values.Sum() / values.Length);
        for (var a = 0; a < values.Length; a++)
        {
            squares += (values[a] - mean) * (values[a] - mean);
            for (var b = 0; b < values.Length; b++)
            {
                var weight = neighbors.Contains((a, b)) || neighbors.Contains((b, a)) ? 1 : 0;
                weights += weight;
                cross += weight * (values[a] - mean) * (values[b] - mean);
            }
        }

        return values.Length / weights * cross / squares;
    }

    private static IEnumerable<double[]> Orders(double[] values) => values.Length == 1
        ? [values]
        : Enumerable.Range(0, values.Length).SelectMany(
            k => Orders([.. values[..k], .. values[(k + 1)..]]).Select(rest => (double[])[values[k], .. rest]));
}
