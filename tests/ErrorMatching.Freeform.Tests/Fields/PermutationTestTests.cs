using System.Globalization;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Whether the permutation test, with one error rate for several statistics, finds what it looks for.</summary>
/// <remarks>The suite tries a few pieces. With <c>REFEREE_SEEDS=400</c> the rates are those of
/// docs/decisions/0011-several-tests-and-kernels.md.</remarks>
public sealed class PermutationTestTests(ITestOutputHelper output)
{
    private static readonly int Seeds = int.Parse(
        Environment.GetEnvironmentVariable("REFEREE_SEEDS") ?? "20", CultureInfo.InvariantCulture);

    public static TheoryData<int> Designs => [1, 2, 3];

    // 5 % with a standard deviation of sqrt(0.05 * 0.95 / n); three of them on either side.
    [Theory]
    [MemberData(nameof(Designs))]
    public void Noise_is_taken_for_a_structure_in_one_of_twenty_pieces(int design) =>
        Assert.InRange(Rate(design, DrawnError.Nothing, 0), 0.05 - Margin(0.05), 0.05 + Margin(0.05));

    [Theory]
    [MemberData(nameof(Designs))]
    public void Waves_of_two_and_a_half_points_are_seen_at_one_and_a_half_times_the_noise(int design) =>
        Assert.InRange(Rate(design, DrawnError.ShortWave, 1.5), 0.95, 1);

    [Theory]
    [MemberData(nameof(Designs))]
    public void Tilts_are_seen_at_half_the_noise(int design) =>
        Assert.InRange(Rate(design, DrawnError.Tilt, 0.5), 0.85 - Margin(0.85), 1);

    [Fact]
    public void The_test_that_found_a_structure_is_named()
    {
        var plan = new MeasuredDesign(PaperDesign.One).Plan.Points;
        var wave = SpatialStructure.Test(Samples(plan, (x, y) => 0.01 * Math.Sin(2 * Math.PI * 37.5 * x / 25), 0.001, 3));
        var tilt = SpatialStructure.Test(Samples(plan, (x, y) => 0.002 * x, 0.002, 3));

        var found = Assert.Single(wave.Found, t => t.Kind == StructureKind.Wave);
        Assert.InRange(found.WaveMm.U, 23, 27);
        Assert.Equal(double.PositiveInfinity, found.WaveMm.V);
        Assert.Contains("a wave of 2", StructureWords.Of(wave), StringComparison.Ordinal);
        Assert.Contains(tilt.Found, t => t.Kind == StructureKind.Plane);
        Assert.Contains("a plane", StructureWords.Of(tilt), StringComparison.Ordinal);
    }

    [Fact]
    public void Neighbors_that_alternate_are_a_structure()
    {
        var plan = new MeasuredDesign(PaperDesign.One).Plan.Points;
        var number = plan.ToDictionary(p => ((2 * p.U) - 1, (2 * p.V) - 1), p => p.I + p.J);
        var structure = SpatialStructure.Test(Samples(plan, (x, y) => number[(x, y)] % 2 == 0 ? 0.003 : -0.003, 0.001, 2));

        Assert.Equal(SpatialVerdict.Systematic, structure.Verdict);
        Assert.True(structure.I < -0.5);
        Assert.Contains(structure.Found, t => t is { Kind: StructureKind.Neighbors, IsOpposite: true });
        Assert.Contains("neighbors are opposite", StructureWords.Of(structure), StringComparison.Ordinal);
    }

    [Fact]
    public void Probabilities_do_not_depend_on_the_order_of_the_points()
    {
        var plan = new MeasuredDesign(PaperDesign.Three).Plan.Points;
        var samples = Samples(plan, (x, y) => 0.0005 * x, 0.001, 8);

        Assert.Equal(
            SpatialStructure.Test(samples).Tests.Select(t => t.P), SpatialStructure.Test([.. samples.Reverse()]).Tests.Select(t => t.P));
    }

    [Fact]
    public void Noise_about_a_good_fit_is_no_structure_and_what_a_poor_fit_leaves_is()
    {
        var samples = TrueShape.MachineError.Samples(noise: 0.001, seed: 2);
        var data = Data(samples);

        Assert.False(LeftStructure.IsIn(data.With([.. FieldFit.Fit(samples).Residuals])));
        Assert.True(LeftStructure.IsIn(data.With([.. samples.Select(s => s.ErrorMm - samples.Average(o => o.ErrorMm))])));
        Assert.False(LeftStructure.IsIn(data.With([.. samples.Select(s => 1e-6 * s.U)])));
    }

    private static double Margin(double rate) => 3 * Math.Sqrt(rate * (1 - rate) / Seeds);

    private double Rate(int design, DrawnError family, double ratio)
    {
        MeasuredDesign piece = design switch
        {
            1 => new(PaperDesign.One),
            2 => new(PaperDesign.Two, "\"pointsPerCurve\": 10", "\"pointsPerCurve\": 7"),
            _ => new(PaperDesign.Three, "\"pointsPerCurve\": 10", "\"points\": 68"),
        };
        var rate = Enumerable.Range(1, Seeds).Count(seed => SpatialStructure.Test(
            Samples(piece.Plan.Points, family.Of((1000 * seed) + 17, 0.003 * ratio), 0.003, (7919 * seed) + 5)).Verdict
            == SpatialVerdict.Systematic) / (double)Seeds;
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{family} on design {design}: {100 * rate:0.0} %"));
        return rate;
    }

    private static ErrorSample[] Samples(IReadOnlyList<PlanPoint> plan, Func<double, double, double> error, double noise, int seed)
    {
        var random = new Noise(seed);
        return [.. plan.Select(p => new ErrorSample(
            p.Number, p.I, p.J, p.U, p.V, p.Position, p.Normal, 0.005 + error((2 * p.U) - 1, (2 * p.V) - 1) + (noise * random.Next())))];
    }

    private static FieldData Data(ErrorSample[] samples) => new(
        [.. samples.Select(s => s.I)],
        [.. samples.Select(s => s.J)],
        [.. samples.Select(s => (2 * s.U) - 1)],
        [.. samples.Select(s => (2 * s.V) - 1)],
        [.. samples.Select(s => s.ErrorMm)]);
}
