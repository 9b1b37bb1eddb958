namespace ErrorMatching.Freeform.Tests;

public sealed class SpatialStructureTests
{
    [Fact]
    public void Morans_I_of_four_in_a_row_is_that_worked_out_by_hand()
    {
        // Values 1 2 3 4, neighbors 1-2, 2-3, 3-4. Deviations -1.5 -0.5 0.5 1.5: products 0.75 - 0.25 + 0.75 = 1.25, both ways 2.5; sum of squares 5.
        // I = n / S0 * 2.5 / 5 = 4 / 6 * 0.5 = 1/3; mean -1/3.
        var s = SpatialStructure.Of([1, 2, 3, 4], [(0, 1), (1, 2), (2, 3)])!;

        Assert.Equal(1.0 / 3, s.I, 12);
        Assert.Equal(-1.0 / 3, s.Expected, 12);
    }

    [Fact]
    public void Mean_and_variance_are_those_of_all_permutations()
    {
        double[] values = [1, 5, 2, 8, 3, 9];
        (int, int)[] neighbors = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (0, 3)];
        var all = Permutations(values).Select(p => SpatialStructure.Of(p, neighbors)!.I).ToArray();
        var s = SpatialStructure.Of(values, neighbors)!;

        Assert.Equal(720, all.Length);
        Assert.Equal(all.Average(), s.Expected, 12);
        Assert.Equal(all.Sum(i => Math.Pow(i - all.Average(), 2)) / all.Length, s.Variance, 12);
    }

    [Theory]
    [InlineData(1.959964, 0.025)]
    [InlineData(1.281552, 0.1)]
    [InlineData(3.090232, 0.001)]
    public void Probability_is_that_of_the_normal_distribution(double z, double p)
    {
        // A record keeps what it is given; the tail is seen through values whose z is known: solved by bisection over a mixture of structure and noise.
        Assert.Equal(p, TailAt(z), 6);
    }

    [Fact]
    public void A_slope_is_systematic_and_noise_is_not()
    {
        var random = new Random(7);
        Assert.True(SpatialStructure.Of(Samples((x, y) => 0.001 * x))!.IsSystematic);
        var verdicts = Enumerable.Range(0, 200).Count(_ => SpatialStructure.Of(Samples((x, y) => random.NextDouble()))!.IsSystematic);

        // One in twenty by the level; twice that is beyond three standard deviations of 200 trials.
        Assert.InRange(verdicts, 1, 20);
    }

    [Fact]
    public void Nothing_is_said_of_a_few_points_or_of_equal_ones()
    {
        Assert.Null(SpatialStructure.Of([.. Samples((x, y) => x).Take(7)]));
        Assert.Null(SpatialStructure.Of(Samples((x, y) => 0.015)));
    }

    private static double TailAt(double z)
    {
        var (low, high) = (0.0, 1.0);
        var noise = new Random(3);
        var (slope, random) = (Samples((x, y) => x).ToArray(), Samples((x, y) => noise.NextDouble() * 75).ToArray());
        SpatialStructure At(double share) => SpatialStructure.Of([.. slope.Select((s, i) => s with { ErrorMm = (share * s.ErrorMm) + ((1 - share) * random[i].ErrorMm) })])!;
        for (var step = 0; step < 80; step++)
        {
            (low, high) = At((low + high) / 2).Z < z ? ((low + high) / 2, high) : (low, (low + high) / 2);
        }

        Assert.Equal(z, At(low).Z, 9);
        return At(low).P;
    }

    private static List<ErrorSample> Samples(Func<double, double, double> error) =>
    [
        .. from j in Enumerable.Range(0, 7) from i in Enumerable.Range(0, 10)
           select new ErrorSample((j * 10) + i + 1, i, j, i / 9.0, j / 6.0, new(i * 75 / 9.0, j * 10.5, 0), new(0, 0, 1), error(i * 75 / 9.0, j * 10.5)),
    ];

    private static IEnumerable<double[]> Permutations(double[] values) => values.Length <= 1
        ? [values]
        : values.SelectMany((v, i) => Permutations([.. values.Where((_, k) => k != i)]).Select(rest => (double[])[v, .. rest]));
}
