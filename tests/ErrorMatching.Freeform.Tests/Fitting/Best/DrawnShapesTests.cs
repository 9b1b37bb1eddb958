namespace ErrorMatching.Freeform.Tests;

/// <summary>What <c>best</c> is held to, mean d2 in micrometers on grids of 10 x 7 points, on shapes that are drawn.</summary>
public sealed class DrawnShapesTests
{
    private static readonly IReadOnlyList<int> Seeds = [.. Enumerable.Range(1, 20)];
    private static readonly IReadOnlyList<int> TenSeeds = [.. Enumerable.Range(1, 10)];

    [Fact]
    public void Any_quadratic_is_met_to_a_hundredth_of_a_micrometer() =>
        Assert.All(Seeds, seed => Assert.InRange(MeanUm(RandomShape.Quadratic(seed), 0, seed), 0, 0.01));

    [Fact]
    public void Any_break_with_two_lines_on_each_side_is_met_to_a_twentieth_of_a_micrometer() =>
        Assert.All(Seeds, seed => Assert.InRange(MeanUm(RandomShape.Break(seed), 0, seed), 0, 0.05));

    [Fact]
    public void Waves_of_the_length_of_the_piece_and_more_are_met_to_a_twentieth_of_a_micrometer_on_average() =>
        Assert.InRange(Seeds.Average(seed => MeanUm(RandomShape.Waves(seed), 0, seed)), 0, 0.05);

    [Fact]
    public void Any_quadratics_with_noise_of_a_micrometer_come_out_within_a_third_of_it_on_average() =>
        Assert.InRange(TenSeeds.Average(seed => MeanUm(RandomShape.Quadratic(seed), 0.001, seed)), 0.1, 0.35);

    [Fact]
    public void Any_waves_with_noise_of_a_micrometer_come_out_within_six_tenths_of_it_on_average() =>
        Assert.InRange(TenSeeds.Average(seed => MeanUm(RandomShape.Waves(seed), 0.001, seed)), 0.1, 0.6);

    // What is missed, and by how much: docs/decisions/0007-fit-the-error-field.md says these figures.
    [Theory]
    [InlineData(0, 5.1, 2.5)]
    [InlineData(0.001, 6.0, 3.0)]
    public void A_break_among_waves_is_missed_as_often_as_is_said(double noise, double mean, double median)
    {
        var left = Seeds.Select(seed => MeanUm(RandomShape.BreakAmongWaves(seed), noise, seed)).Order().ToArray();

        Assert.InRange(left.Average(), 0, mean + 0.1);
        Assert.InRange((left[9] + left[10]) / 2, 0, median + 0.1);
    }

    [Fact]
    public void An_oblique_break_leaves_what_is_said()
    {
        var left = Seeds.Select(seed => MeanUm(RandomShape.ObliqueBreak(seed), 0, seed)).ToArray();

        Assert.InRange(left.Average(), 0, 8);
        Assert.InRange(left.Max(), 0, 24);
    }

    private static double MeanUm(TrueShape shape, double noise, int seed) =>
        shape.DistanceUm(
            SurfaceFitter.Fit(shape.Grid(noise: noise, seed: seed), FitMethod.Best, JobFit.Default.CurveToleranceMm).Surface).Mean;
}
