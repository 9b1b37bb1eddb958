using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Fits;

public class WedgeTests
{
    [Fact]
    public void Right_notch_has_its_apex_where_the_flanks_meet()
    {
        var wedge = Wedge.Fit([new(-3, 3), new(-1, 1)], [new(2, 2), new(5, 5)]);
        Assert.Equal(0, wedge.Apex.DistanceTo(new(0, 0)), 14);
        Assert.Equal(90, wedge.IncludedAngle.Degrees, 12);
        Assert.Equal(Math.Sqrt(18), wedge.FirstLength, 12);
        Assert.Equal(Math.Sqrt(50), wedge.SecondLength, 12);
        Assert.True(wedge.FirstDirection.X < 0 && wedge.SecondDirection.X > 0);
    }

    [Fact]
    public void Angle_is_seen_from_the_apex_toward_the_points_whatever_their_order()
    {
        Point2[] right = [new(1, 0), new(5, 0)];
        Point2[] up = [Direction(150, 1), Direction(150, 4)];
        Assert.Equal(150, Wedge.Fit(right, up).IncludedAngle.Degrees, 12);
        Assert.Equal(150, Wedge.Fit([.. right.Reverse()], [.. up.Reverse()]).IncludedAngle.Degrees, 12);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(60)]
    [InlineData(118.948)]
    [InlineData(179)]
    public void Included_angle_is_recovered_anywhere(double degrees) =>
        Draw.Law(Draw.Transform, t =>
        {
            var wedge = Wedge.Fit(
                [.. new[] { 2.0, 7 }.Select(r => t.Apply(Direction(0, r)))],
                [.. new[] { 3.0, 8 }.Select(r => t.Apply(Direction(degrees, r)))]);
            return Math.Abs(wedge.IncludedAngle.Degrees - degrees) < 1e-9 && wedge.Apex.DistanceTo(t.Apply(new Point2(0, 0))) < 1e-9
                && Math.Abs(wedge.FirstLength - 7) < 1e-9 && Math.Abs(wedge.SecondLength - 8) < 1e-9;
        }, 100);

    [Fact]
    public void Uncertainty_of_apex_and_angle_is_what_repeated_measuring_shows()
    {
        // Flanks from the origin at 20 and 95 degrees, each by two points with a known uncertainty:
        // the apex of 20000 such wedges scatters as one of them claims.
        const double sigma = 0.002;
        const int count = 20_000;
        var nominal = Flanks(new double[4]);
        var claimed = Wedge.Fit(nominal[..2], nominal[2..], sigma);
        var (x, y, angle) = (0.0, 0.0, 0.0);
        for (var k = 0; k < count; k++)
        {
            // Uniform noise has a standard deviation of its half width over the square root of 3.
            var noise = Draw.Noise(k, 4);
            var points = Flanks([.. noise.Select(n => n * sigma * Math.Sqrt(3))]);
            var wedge = Wedge.Fit(points[..2], points[2..]);
            x += wedge.Apex.X * wedge.Apex.X;
            y += wedge.Apex.Y * wedge.Apex.Y;
            angle += Math.Pow(wedge.IncludedAngle.Radians - claimed.IncludedAngle.Radians, 2);
        }

        Assert.InRange(Math.Sqrt(x / count) / claimed.ApexStandardError.X, 0.97, 1.03);
        Assert.InRange(Math.Sqrt(y / count) / claimed.ApexStandardError.Y, 0.97, 1.03);
        Assert.InRange(Math.Sqrt(angle / count) / claimed.IncludedAngleStandardError.Radians, 0.97, 1.03);

        static Point2[] Flanks(double[] across) =>
        [
            Direction(20, 4) + (Direction(110, 1) - Point2.Origin) * across[0],
            Direction(20, 9) + (Direction(110, 1) - Point2.Origin) * across[1],
            Direction(95, 3) + (Direction(185, 1) - Point2.Origin) * across[2],
            Direction(95, 10) + (Direction(185, 1) - Point2.Origin) * across[3],
        ];
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(179.6)]
    public void Near_parallel_flanks_are_refused_with_their_angle(double degrees)
    {
        var refusal = Refused.With(
            GeometryError.NearParallel,
            () => Wedge.Fit([Direction(0, 1), Direction(0, 5)], [Direction(degrees, 2), Direction(degrees, 6)]));
        Assert.Contains(
            (degrees > 90 ? 0.4 : degrees).ToString("0.#", System.Globalization.CultureInfo.InvariantCulture) + " degrees",
            refusal.Message,
            StringComparison.Ordinal);
    }

    private static Point2 Direction(double degrees, double length) =>
        Point2.Origin + (Vector2.FromDirection(Angle.FromDegrees(degrees)) * length);
}
