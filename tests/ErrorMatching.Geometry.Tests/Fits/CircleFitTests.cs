using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Fits;

public class CircleFitTests
{
    [Fact]
    public void Published_geometric_fit_is_reproduced()
    {
        // Gander, Golub and Strebel, "Least-squares fitting of circles and ellipses", BIT 34 (1994), section 1:
        // six points and their geometric fit.
        var fit = CircleFit.Fit([new(1, 7), new(2, 6), new(5, 8), new(7, 7), new(9, 5), new(3, 7)]);
        Assert.Equal(4.7398, fit.Circle.Center.X, 4);
        Assert.Equal(2.9835, fit.Circle.Center.Y, 4);
        Assert.Equal(4.7142, fit.Circle.Radius, 4);
        Assert.Equal(1.2276, fit.Residuals.Sum(r => r * r), 4);
        Assert.Equal(Math.Sqrt(1.2276 / 3), fit.ResidualStandardDeviation, 4);
    }

    [Fact]
    public void Even_points_all_around_have_the_errors_of_the_closed_form()
    {
        // For n points evenly around, the linearized design has the Gram matrix diag(n/2, n/2, n).
        var fit = CircleFit.Fit(
            [.. Enumerable.Range(0, 8).Select(i => new Circle2(new(10, -20), 30).At(Angle.FromDegrees(45 * i)))], 0.004);
        Assert.Equal(0.002, fit.CenterStandardError.X, 12);
        Assert.Equal(0.002, fit.CenterStandardError.Y, 12);
        Assert.Equal(0.004 / Math.Sqrt(8), fit.RadiusStandardError, 12);
        Assert.Equal(Math.Sqrt(2), fit.Condition, 12);
    }

    [Fact]
    public void Exact_arc_is_recovered() =>
        Draw.Law(Draw.Circle.Zip(Draw.Angle).Zip(FsCheck.Fluent.Gen.Choose(30, 350)), p =>
        {
            var ((circle, start), sweep) = p;
            var fit = CircleFit.Fit([.. Enumerable.Range(0, 9).Select(i => circle.At(start + Angle.FromDegrees(sweep * i / 8.0)))]);
            return fit.Circle.Center.DistanceTo(circle.Center) < 1e-9
                && Math.Abs(fit.Circle.Radius - circle.Radius) < 1e-9
                && fit.ResidualStandardDeviation < 1e-10;
        });

    [Fact]
    public void Fit_moves_with_the_points() =>
        Draw.Law(Draw.Circle.Zip(Draw.Transform).Zip(FsCheck.Fluent.Gen.Choose(0, 10_000)), p =>
        {
            var ((circle, transform), seed) = p;
            var noise = Draw.Noise(seed, 12);
            Point2[] points = [
                .. noise.Select((e, i) => new Circle2(circle.Center, circle.Radius * (1 + (0.01 * e))).At(Angle.FromDegrees(20 * i)))];
            var (fit, moved) = (CircleFit.Fit(points), CircleFit.Fit([.. points.Select(transform.Apply)]));
            return moved.Circle.Center.DistanceTo(transform.Apply(fit.Circle.Center)) < 1e-8
                && Math.Abs(moved.Circle.Radius - fit.Circle.Radius) < 1e-8
                && Math.Abs(moved.RadiusStandardError - fit.RadiusStandardError) < 1e-8;
        }, 300);

    // Coordinates of a machine far from its origin: a micrometer there is the tenth digit.
    [Theory]
    [InlineData(0)]
    [InlineData(1 << 20)]
    [InlineData(5_000_000)]
    [InlineData(-1_000_000_000)]
    public void Distance_from_the_origin_costs_no_digits_of_the_radius(double far)
    {
        Point2[] near = [new(12.5, 0.25), new(3, 12.125), new(-8.75, 9), new(-12, -3.5), new(-1.5, -12.375), new(10, -7.5)];
        var (fit, moved) = (CircleFit.Fit(near), CircleFit.Fit([.. near.Select(p => new Point2(p.X + far, p.Y - (far / 4)))]));
        Assert.Equal(fit.Circle.Radius, moved.Circle.Radius, 1e-9);
        Assert.Equal(fit.Circle.Center.X + far, moved.Circle.Center.X, 1e-9 + (2e-16 * Math.Abs(far)));
        Assert.Equal(fit.Circle.Center.Y - (far / 4), moved.Circle.Center.Y, 1e-9 + (2e-16 * Math.Abs(far)));
        Assert.All(fit.Residuals.Zip(moved.Residuals), r => Assert.Equal(r.First, r.Second, 1e-9));
    }

    [Fact]
    public void No_neighboring_circle_is_nearer_to_the_points()
    {
        Point2[] points = [new(1, 7), new(2, 6), new(5, 8), new(7, 7), new(9, 5), new(3, 7)];
        var (circle, best) = (CircleFit.Fit(points).Circle, CircleFit.Fit(points).Residuals.Sum(r => r * r));
        foreach (var (dx, dy, dr) in ((double, double, double)[])[
            (1e-3, 0, 0), (-1e-3, 0, 0), (0, 1e-3, 0), (0, -1e-3, 0), (0, 0, 1e-3), (0, 0, -1e-3), (1e-3, 1e-3, -1e-3)])
        {
            var other = new Circle2(circle.Center + new Vector2(dx, dy), circle.Radius + dr);
            Assert.True(points.Sum(q => Math.Pow(other.SignedDistance(q), 2)) > best);
        }
    }

    [Fact]
    public void Scatter_of_repeated_fits_is_the_stated_standard_error()
    {
        const int count = 4000;
        var (x, radius, claimedX, claimedRadius) = (0.0, 0.0, 0.0, 0.0);
        for (var k = 0; k < count; k++)
        {
            var noise = Draw.Noise(k, 10);
            var fit = CircleFit.Fit([.. noise.Select((e, i) => new Circle2(new(0, 0), 20 + (0.005 * e)).At(Angle.FromDegrees(13 * i)))]);
            x += Math.Pow(fit.Circle.Center.X, 2);
            radius += Math.Pow(fit.Circle.Radius - 20, 2);
            claimedX += Math.Pow(fit.CenterStandardError.X, 2);
            claimedRadius += Math.Pow(fit.RadiusStandardError, 2);
        }

        Assert.InRange(x / claimedX, 0.92, 1.08);
        Assert.InRange(radius / claimedRadius, 0.92, 1.08);
    }

    [Fact]
    public void What_cannot_be_a_circle_is_refused_by_name()
    {
        Refused.With(GeometryError.TooFewPoints, () => CircleFit.Fit([new(0, 0), new(1, 0)]));
        Refused.With(GeometryError.CollinearPoints, () => CircleFit.Fit([new(0, 0), new(1, 1), new(2, 2), new(3, 3)]));
        Refused.With(GeometryError.CollinearPoints, () => CircleFit.Fit([new(0, 0), new(10, 1e-9), new(20, 0)]));
        Refused.With(GeometryError.CoincidentPoints, () => CircleFit.Fit([new(0, 0), new(1, 1), new(0, 0), new(1, 1)]));
        Refused.With(GeometryError.CoincidentPoints, () => CircleFit.Fit([new(2, 2), new(2, 2), new(2, 2)]));
        Refused.With(GeometryError.NotFinite, () => CircleFit.Fit([new(0, 0), new(1, 0), new(double.NaN, 2)]));
        Assert.Throws<ArgumentOutOfRangeException>(() => CircleFit.Fit([new(0, 0), new(1, 0), new(0, 2)], -1));
    }

    [Fact]
    public void Nearly_straight_arc_is_still_a_circle()
    {
        var circle = new Circle2(new(0, -5000), 5000);
        var fit = CircleFit.Fit([.. Enumerable.Range(0, 15).Select(i => circle.At(Angle.FromDegrees(89.5 + (i / 14.0))))]);
        Assert.Equal(5000, fit.Circle.Radius, 3);
    }
}
