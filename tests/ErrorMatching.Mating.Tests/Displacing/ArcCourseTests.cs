using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>
/// An arc follows as a circle, the one nearest to the deviation over its whole length. The points lie on the upper half circle of radius
/// 10 about (20, 0), from -60 to 60 degrees in steps of 30; the arc goes on for 30 degrees on both sides.
/// </summary>
public sealed class ArcCourseTests
{
    // The circle of radius 10.05 about (20.03, -0.02): its ends are 0.08 and 0.02 out in x, its top is 0.03 out.
    [Fact]
    public void An_arc_takes_a_circle_that_its_points_lie_on()
    {
        var wish = Wish(phi =>
        {
            var (along, across) = ((0.03 * Math.Sin(phi)) - (0.02 * Math.Cos(phi)), (0.03 * Math.Cos(phi)) + (0.02 * Math.Sin(phi)));
            return along + Math.Sqrt((10.05 * 10.05) - (across * across));
        });

        Assert.Equal(-0.02, wish.Start.X, 2e-4);
        Assert.Equal(0.03, wish.Middle.Y, 2e-4);
        Assert.Equal(0.08, wish.End.X, 2e-4);
    }

    // Of 0.028 phi^2, the circle nearest over the half circle is 0.06557 out at both ends and 0.00125 in at its top, by the integrals of
    // phi^2 and cos phi. Five points, none of them behind 60 degrees, tell it to 4 um. The circle nearest to the points alone is 0.0617
    // out at the ends.
    [Fact]
    public void An_arc_whose_points_lie_on_no_circle_takes_the_one_nearest_to_their_course()
    {
        var wish = Wish(phi => 10 + (0.028 * phi * phi));

        Assert.Equal(-0.06557, wish.Start.X, 0.004);
        Assert.Equal(-0.00125, wish.Middle.Y, 0.004);
        Assert.Equal(0.06557, wish.End.X, 0.004);
    }

    private static ElementWish Wish(Func<double, double> radius) => Assert.Single(new MatchCase(Programs.Hill)
    {
        Theoretical = Points(_ => 10),
        Part = Points(radius),
        Features = [MatchCase.Feature("curve", "C1", "N50", """["0..4"]""")],
    }.Match().Wish!.Elements);

    private static string Points(Func<double, double> radius) => string.Join("; ", Enumerable.Range(0, 5).Select(i =>
    {
        var phi = (i - 2) * Math.PI / 6;
        return FormattableString.Invariant(
            $"{i} {20 + (radius(phi) * Math.Sin(phi)):0.000000000} {radius(phi) * Math.Cos(phi):0.000000000}");
    }));
}
