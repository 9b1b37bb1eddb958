using ErrorMatching.Geometry;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Circles that are measured at few points, whose form error nobody stated.</summary>
public sealed class WholeShapeTests
{
    private const double U = 0.002;
    private const int Around = 36;
    private static readonly int Circles = Depth.Of(300, 3000);

    // The circles are drawn here: a shift, a growth, waves of two to four periods. What is left over after the estimate was followed is
    // compared with the bound. 93 % are promised; of few circles, chance is allowed for.
    [Theory]
    [InlineData(6, 0)]
    [InlineData(6, 1)]
    [InlineData(8, 1)]
    [InlineData(8, 3)]
    [InlineData(12, 0.5)]
    [InlineData(12, 1)]
    [InlineData(12, 2)]
    [InlineData(24, 0.5)]
    public void The_bound_holds_the_largest_error_however_large_the_form_is(int points, double formByU)
    {
        var random = new NormalVariates(7);
        var held = 0;
        for (var circle = 0; circle < Circles; circle++)
        {
            double[] waves = [.. Enumerable.Range(0, 6).Select(_ => formByU * U / Math.Sqrt(3) * random.Next())];
            double[] shape = [.. Enumerable.Range(0, 3).Select(_ => 0.02 * random.Next())];
            var estimate = Estimate(points, Math.PI * random.Next(), t => True(t) + (U * random.Next()));
            var largest = Enumerable.Range(0, Around)
                .Max(k => Math.Abs(True(Angle(k)) - estimate.DeviationAt(estimate.Places[k].Place, estimate.Places[k].Normal)));
            held += largest <= estimate.BoundMm(new double[Around], null, 0.05) ? 1 : 0;

            double True(double t) => shape[0] + (shape[1] * Math.Cos(t)) + (shape[2] * Math.Sin(t)) + Wave(waves, t);
        }

        Assert.InRange(held, (0.93 * Circles) - (2 * Math.Sqrt(0.93 * 0.07 * Circles)), Circles);
    }

    private static WholeShape Estimate(int points, double first, Func<double, double> measured) => WholeShape.Estimate(
        [
            .. Enumerable.Range(0, points).Select(k => first + (2 * Math.PI * k / points))
                .Select(t => (At(t).Place, At(t).Normal, measured(t)))],
        [],
        U) with
    {
        Places = [.. Enumerable.Range(0, Around).Select(k => At(Angle(k)))],
    };

    // Two, three and four lobes.
    private static double Wave(double[] waves, double t) =>
        Enumerable.Range(2, 3).Sum(n => (waves[(2 * n) - 4] * Math.Cos(n * t)) + (waves[(2 * n) - 3] * Math.Sin(n * t)));

    private static double Angle(int place) => 2 * Math.PI * place / Around;

    private static (Point2 Place, Vector2 Normal) At(double t) => (new(12 * Math.Cos(t), 12 * Math.Sin(t)), new(Math.Cos(t), Math.Sin(t)));
}
