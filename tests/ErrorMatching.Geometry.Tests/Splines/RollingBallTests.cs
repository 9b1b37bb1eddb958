using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

/// <summary>A ball that is said to roll freely does, seen from any place of the surface.</summary>
public sealed class RollingBallTests
{
    private static readonly KnotVector Quadratic = KnotVector.Clamped(2, [0, 1]);

    [Theory]
    [InlineData(0.5)]
    [InlineData(3)]
    public void It_rolls_in_a_cylinder_that_is_three_times_as_wide(double radius) =>
        Assert.NotNull(new RollingBall(Shapes.Cylinder(10, 40), radius).FreeAround(0.5, 0.5));

    [Theory]
    [InlineData(10.001)]
    [InlineData(12)]
    public void It_does_not_roll_in_a_cylinder_that_is_narrower(double radius) =>
        Assert.Null(new RollingBall(Shapes.Cylinder(10, 40), radius).FreeAround(0.5, 0.5));

    [Fact]
    public void It_rolls_all_over_a_plane()
    {
        var free = new RollingBall(Shapes.Plane(50, 30), 100).FreeAround(0.3, 0.7);

        Assert.Equal((new Point2(0, 0), new Point2(1, 1)), free);
    }

    [Fact]
    public void It_does_not_roll_between_walls_that_are_nearer_than_its_diameter()
    {
        // A sheet bent like a U: nothing of it bends more than 1 / 5 mm, but walls stand 10 mm apart.
        static Point3 At(double angle, double y) => new(5 * Math.Sin(angle), y, -5 * Math.Cos(angle));
        var sheet = Sheet(96, t => t < 1 ? new(-5, 0, 20 * (1 - t)) : t > 2 ? new(5, 0, 20 * (t - 2)) : At((t - 1.5) * Math.PI, 0), 3);

        Assert.Null(new RollingBall(sheet, 5.5).FreeAround(0.2, 0.5));
        Assert.NotNull(new RollingBall(sheet, 3).FreeAround(0.2, 0.5));
    }

    [Fact]
    public void It_does_not_roll_over_an_edge()
    {
        var knots = new KnotVector(1, [0, 0, 0.5, 1, 1]);
        var roof = new SplineSurface(
            knots,
            KnotVector.Clamped(1, [0, 1]),
            [new(0, 0, 0), new(0, 10, 0), new(10, 0, 4), new(10, 10, 4), new(20, 0, 0), new(20, 10, 0)]);

        Assert.Null(new RollingBall(roof, 1).FreeAround(0.499, 0.5));
    }

    [Fact]
    public void Where_it_is_said_to_roll_no_place_of_the_surface_is_nearer_to_its_center_than_its_radius()
    {
        var (asked, free) = (0, 0);
        Draw.Law(
            Gen.Choose(0, 1_000_000).Zip(Gen.Choose(1, 60)).Zip(Gen.Choose(2, 40)),
            c =>
            {
                var ((seed, height), tenth) = c;
                var noise = Draw.Noise(seed, 100);
                var knots = KnotVector.Clamped(3, [0, 0.3, 0.4, 1]);
                var poles = Enumerable.Range(0, 36).Select(i => new Point3(
                    (8 * (i / 6)) + noise[i], (6 * (i % 6)) + noise[i + 36], 0.1 * height * noise[(i * 2) % 97]));
                var surface = new SplineSurface(knots, knots, [.. poles]);
                var radius = 0.25 * tenth;
                var ball = new RollingBall(surface, radius);
                for (var i = 0; i <= 12; i++)
                {
                    for (var j = 0; j <= 12; j++)
                    {
                        var at = surface.At(i / 12.0, j / 12.0);
                        asked++;
                        if (ball.FreeAround(at.U, at.V) is not { } part)
                        {
                            continue;
                        }

                        free++;
                        if (at.U < part.From.X || at.V < part.From.Y || at.U > part.To.X || at.V > part.To.Y
                            || surface.ClosestPoint(at.Position + (at.Normal * radius)).Distance < radius - 1e-6
                                || surface.ClosestPoint(at.Position + (at.Normal * -radius)).Distance < radius - 1e-6)
                        {
                            return false;
                        }
                    }
                }

                return true;
            },
            60);

        // Neither always nor never, or the law says nothing.
        Assert.InRange((double)free / asked, 0.01, 0.99);
    }

    // A sheet along y through places of a curve, smooth, as a B-spline of the third degree.
    private static SplineSurface Sheet(int count, Func<double, Point3> at, double last)
    {
        var knots = KnotVector.Clamped(3, [.. Enumerable.Range(0, count - 2).Select(i => (double)i / (count - 3))]);
        var poles = new List<Point3>();
        for (var i = 0; i < count; i++)
        {
            var place = at(last * i / (count - 1));
            poles.Add(place);
            poles.Add(place with { Y = 20 });
        }

        return new(knots, KnotVector.Clamped(1, [0, 1]), [.. poles]);
    }
}
