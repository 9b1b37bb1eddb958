using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Surfaces of which only 12 to 30 points are measured: what is compensated, and which points are distrusted.</summary>
public sealed class FewPointsTests
{
    private const double Deviation = 0.004;

    private static readonly MeasuredDesign[] Plans = [Plan(3, 4), Plan(4, 4), Plan(5, 5), Plan(4, 7)];

    // Neither of a field nor of noise, whatever is stated of a point, is more left at the points than by mirroring each point's own error.
    // Smooth fields gain, and none loses more than a fifth of what the noise leaves.
    [Theory]
    [InlineData(0, 0.000125, 0.000125)]
    [InlineData(1, 0.000125, 0.001)]
    [InlineData(2, 0.001, 0.001)]
    [InlineData(3, 0.002, 0.002)]
    public void No_more_is_left_than_by_the_plain_mirror(int plan, double stated, double noise)
    {
        foreach (var piece in Plans.Where((_, i) => i % Depth.Of(4, 1) == plan % Depth.Of(4, 1)).Select(p => Stating(p, stated)))
        {
            foreach (var family in DrawnError.Repeating.Append(DrawnError.Nothing))
            {
                var (own, mirror) = (0.0, 0.0);
                for (var seed = 1; seed <= 2; seed++)
                {
                    var (truth, errors) = Draw(piece, family, noise, seed);
                    var result = piece.Compensate(piece.With((u, v) => errors[(u, v)])).Result;
                    if (result is null)
                    {
                        // A bump that one point sees: its measurement has to be repeated.
                        Assert.Equal("bump", family.Name);
                        continue;
                    }

                    own += piece.Plan.Points.Sum(p => Square(truth(p.U, p.V) - result.Compensated.At(p.U, p.V)));
                    mirror += piece.Plan.Points.Sum(p => Square(truth(p.U, p.V) - errors[(p.U, p.V)]));
                }

                Assert.True(
                    Math.Sqrt(own) <= 1.2 * Math.Sqrt(mirror),
                    $"{piece.Plan.Points.Count} points, {family.Name}: {Math.Sqrt(own)} after {Math.Sqrt(mirror)}");
            }
        }
    }

    // The errors of a perfect piece are noise of the stated uncertainty: at most a twentieth of such pieces may be compensated.
    [Fact]
    public void Noise_of_the_stated_size_is_seldom_followed()
    {
        var piece = Stating(Plans[0], 0.001);
        var followed = Enumerable.Range(1, 100).Count(seed =>
        {
            var (_, errors) = Draw(piece, DrawnError.Nothing, 0.001, seed, 0);
            return piece.Compensate(piece.With((u, v) => errors[(u, v)])).Result!.Systematic is not ConstantField;
        });

        // Of 100 with 5 %, more than 10 are found once in a hundred times.
        Assert.InRange(followed, 1, 10);
    }

    [Fact]
    public void Dust_on_any_point_is_named_and_on_none_nothing_is()
    {
        foreach (var piece in Plans)
        {
            foreach (var family in DrawnError.Repeating.Where(f => f.Name != "bump").Append(DrawnError.Nothing))
            {
                var (_, errors) = Draw(piece, family, 0.001, 3);
                Assert.True(piece.Compensate(piece.With((u, v) => errors[(u, v)])).IsUsable, family.Name);
                foreach (var bad in piece.Plan.Points.Where(p => p.Number % Depth.Of(9, 3) == 1))
                {
                    var refusal = piece.Compensate(piece.With(
                        (u, v) => errors[(u, v)] + ((u, v) == (bad.U, bad.V) ? 0.15 : 0))).Refusal;
                    Assert.Equal("outlying-point", refusal?.Code);
                    Assert.StartsWith($"Point {bad.Number} ", refusal!.Message, StringComparison.Ordinal);
                    Assert.DoesNotContain("likewise", refusal.Message, StringComparison.Ordinal);
                }
            }
        }
    }

    [Fact]
    public void Two_bad_touches_of_twenty_eight_are_both_named()
    {
        var piece = Plans[3];
        var (_, errors) = Draw(piece, DrawnError.Quadratic, 0.001, 5);
        var (one, other) = (piece.Plan.Points[4], piece.Plan.Points[20]);
        var refusal = piece.Compensate(piece.With((u, v) =>
            errors[(u, v)] + ((u, v) == (one.U, one.V) ? 0.15 : (u, v) == (other.U, other.V) ? 0.1 : 0))).Refusal;
        Assert.StartsWith($"Point {one.Number} ", refusal?.Message, StringComparison.Ordinal);
        Assert.Contains($" point {other.Number}", refusal!.Message, StringComparison.Ordinal);
    }

    // The person who finds a chip takes the point out; what is cut there then follows from the points around.
    [Fact]
    public void A_bad_point_may_be_taken_out_and_the_rest_is_compensated_as_without_it()
    {
        foreach (var piece in Plans)
        {
            var (truth, errors) = Draw(piece, DrawnError.Quadratic, 0.0005, 5);
            var bad = piece.Plan.Points[5];
            MeasuredPoints Dusty(double mm) => piece.With((u, v) => errors[(u, v)] + ((u, v) == (bad.U, bad.V) ? mm : 0));
            Assert.Equal("outlying-point", piece.Compensate(Dusty(0.15)).Refusal?.Code);
            var without = piece.With(piece.Job with { Measuring = piece.Job.Measuring with { Without = [bad.Number] } });
            var result = without.Compensate(Dusty(0.15)).Result!;
            Assert.DoesNotContain(result.Samples, s => s.Point == bad.Number);
            Assert.Equal(piece.Plan.Points.Count - 1, result.Samples.Count);
            Assert.Contains(result.Notes, n => n.StartsWith($"Point {bad.Number} is left out", StringComparison.Ordinal));

            // Whatever was read there.
            var other = without.Compensate(Dusty(-0.1)).Result!;
            Assert.All(piece.Plan.Points, p => Assert.Equal(result.Compensated.At(p.U, p.V), other.Compensated.At(p.U, p.V), 1e-12));

            // The truth of the place that nobody knows, to what its neighbors tell.
            Assert.Equal(truth(bad.U, bad.V), result.Compensated.At(bad.U, bad.V), Deviation / 2);
        }
    }

    [Fact]
    public void A_point_to_be_taken_out_must_be_one_of_the_plan()
    {
        var piece = Plans[0].With(Plans[0].Job with { Measuring = Plans[0].Job.Measuring with { Without = [7, 13] } });
        var refusal = piece.Compensate(piece.With(MeasuredDesign.Tilted)).Refusal;
        Assert.Equal("unknown-point", refusal?.Code);
        Assert.Equal("measuring.without names point 13, and the plan has points 1 to 12.", refusal!.Message);
    }

    // At the margins: what is less than 5 um off, or less than twice the spread of the others, may be the surface.
    [Theory]
    [InlineData(0.0049, 0, false)]
    [InlineData(0.0051, 0, true)]
    [InlineData(0.02, 0.016, false)]
    [InlineData(0.03, 0.016, true)]
    public void A_point_is_named_only_if_it_is_far_off(double dust, double tilt, bool isNamed)
    {
        var piece = Plans[2];
        var bad = piece.Plan.Points.Single(p => (p.I, p.J) == (2, 2));
        var outcome = piece.Compensate(piece.With((u, v) => (tilt * 2 * (u - 0.5)) + ((u, v) == (bad.U, bad.V) ? dust : 0)));
        Assert.Equal(isNamed ? "outlying-point" : null, outcome.IsUsable ? null : outcome.Refusal.Code);
    }

    [Fact]
    public void Four_points_are_said_not_to_contradict_each_other()
    {
        var piece = Plan(2, 2);
        Assert.Contains(
            piece.Compensate(piece.With(MeasuredDesign.Tilted)).Result!.Notes,
            n => n.StartsWith("4 points cannot contradict each other", StringComparison.Ordinal));
        Assert.DoesNotContain(
            Plans[0].Compensate(Plans[0].With(MeasuredDesign.Tilted)).Result!.Notes,
            n => n.Contains("contradict", StringComparison.Ordinal));
    }

    // Two points and a half to a wave. The fit passes through each point and nothing else is known between them.
    [Fact]
    public void A_wave_that_the_points_cannot_hold_is_warned_of()
    {
        var piece = Plans[2];
        var wave = piece.Compensate(piece.With(Wave(1.7)));
        Assert.Equal(["2.4"], Assert.Single(wave.Result!.Warnings, w => w.Code == "few-points-for-wave").Values);
        var longer = piece.Compensate(piece.With(Wave(1.2)));
        Assert.DoesNotContain(longer.Result!.Warnings, w => w.Code == "few-points-for-wave");
        Assert.DoesNotContain(
            piece.Compensate(piece.With(MeasuredDesign.Tilted)).Result!.Warnings,
            w => w.Code is "points-too-far-apart" or "few-points-for-wave");

        static Func<double, double, double> Wave(double waves) => (u, v) =>
            0.004 * Math.Sin((2 * Math.PI * waves * u) + 0.4) * Math.Cos(2 * Math.PI * waves * v);
    }

    [Fact]
    public void What_is_followed_point_by_point_is_said_to_be()
    {
        var (_, errors) = Draw(Plans[0], DrawnError.Nothing, 0.003, 2);
        var warning = Assert.Single(
            Plans[0].Compensate(Plans[0].With((u, v) => errors[(u, v)])).Result!.Warnings, w => w.Code == "follows-each-of-few");
        Assert.Equal(["12", "0.125"], warning.Values);
    }

    private static MeasuredDesign Plan(int curves, int points) => new(
        PaperDesign.One,
        "\"curves\": 7, \"pointsPerCurve\": 10",
        string.Create(CultureInfo.InvariantCulture, $"\"curves\": {curves}, \"pointsPerCurve\": {points}"));

    private static MeasuredDesign Stating(MeasuredDesign piece, double uncertainty) =>
        piece.With(piece.Job with { Measuring = piece.Job.Measuring with { UncertaintyMm = uncertainty } });

    // The truth over the parameters of the surface, and what is measured at each point.
    private static (Func<double, double, double> Truth, Dictionary<(double U, double V), double> Errors) Draw(
        MeasuredDesign piece, DrawnError family, double noise, int seed, double mean = 0.005)
    {
        var (drawn, random) = (family.Of((1000 * seed) + 17, Deviation), new Noise((7919 * seed) + 5));
        double Truth(double u, double v) => mean + drawn((2 * u) - 1, (2 * v) - 1);
        return (Truth, piece.Plan.Points.ToDictionary(p => (p.U, p.V), p => Truth(p.U, p.V) + (noise * random.Next())));
    }

    private static double Square(double x) => x * x;
}
