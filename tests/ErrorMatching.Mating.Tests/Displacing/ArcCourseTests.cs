using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>
/// An arc follows as a circle as long as that predicts its key points to half an increment, else it follows the smooth course.
/// The deviation is k phi^2 over the upper half circle of radius 10, measured from -60 to 60 degrees in steps of 30.
/// A parabola meets it exactly; the best circle leaves a mean leave-one-out error of 0.000483 mm for k = 0.026 and 0.000519 mm for k =
/// 0.028 (least squares by an independent program).
/// </summary>
public sealed class ArcCourseTests
{
    // The same program gives 0.057326 mm outward at both ends of that circle, and 0.000344 mm inward at its top.
    [Fact]
    public void An_arc_takes_the_circle_that_predicts_its_points_to_half_an_increment()
    {
        var wish = Wish(0.026);

        Assert.Equal(-0.057326, wish.Start.X, 5e-6);
        Assert.Equal(-0.000344, wish.Middle.Y, 5e-6);
        Assert.Equal(0.057326, wish.End.X, 5e-6);
    }

    // The parabola is level at the top; behind the last point it goes on straight:
    // k (p^2 + 2 p q) for p = 60 and q = 30 degrees, 0.061411 mm.
    [Fact]
    public void An_arc_whose_points_the_circle_misses_takes_the_smooth_course()
    {
        var wish = Wish(0.028);
        var (last, step) = (Math.PI / 3, Math.PI / 6);
        var end = 0.028 * ((last * last) + (2 * last * step));

        Assert.Equal(-end, wish.Start.X, 5e-6);
        Assert.Equal(0, wish.Middle.Y, 5e-6);
        Assert.Equal(end, wish.End.X, 5e-6);
    }

    private static ElementWish Wish(double k) => Assert.Single(new MatchCase(Programs.Hill)
    {
        Theoretical = Points(_ => 10),
        Part = Points(phi => 10 + (k * phi * phi)),
        Features = [MatchCase.Feature("curve", "C1", "N50", """["0..4"]""", """ "toleranceMm": [0, 0], "degree": 2, "ridge": 0 """)],
    }.Match().Wish!.Elements);

    private static string Points(Func<double, double> radius) => string.Join("; ", Enumerable.Range(0, 5).Select(i =>
    {
        var phi = (i - 2) * Math.PI / 6;
        return FormattableString.Invariant(
            $"{i} {20 + (radius(phi) * Math.Sin(phi)):0.000000000} {radius(phi) * Math.Cos(phi):0.000000000}");
    }));
}
