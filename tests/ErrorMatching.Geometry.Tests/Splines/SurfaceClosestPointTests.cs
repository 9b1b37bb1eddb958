using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SurfaceClosestPointTests
{
    private const double Tolerance = 1e-7;

    private static readonly Gen<Point3> Near = Draw.Coordinate.Three().Select(c => new Point3(c.Item1, c.Item2, c.Item3));

    private static readonly SplineSurface Plane = Shapes.Plane(75, 63);
    private static readonly SplineSurface Cylinder = Shapes.Cylinder(20, 50);
    private static readonly SplineSurface Sphere = Shapes.Sphere(40);
    private static readonly SplineSurface Waves = Shapes.Waves();

    [Fact]
    public void Foot_on_a_plane_is_the_point_clamped_to_its_sides() => Draw.Law(Near, p =>
    {
        var foot = Plane.ClosestPoint(p);
        var expected = new Point3(Math.Clamp(p.X, 0, 75), Math.Clamp(p.Y, 0, 63), 0);
        return (foot.At.Position - expected).Length < 1e-11 && foot.Accuracy <= Tolerance;
    });

    [Fact]
    public void Distance_from_a_quarter_of_a_cylinder_is_that_of_its_closed_form() => Draw.Law(Near, p =>
    {
        var foot = Cylinder.ClosestPoint(p);
        var beside = p.Z - Math.Clamp(p.Z, 0, 50);
        var across = p.X >= 0 && p.Y >= 0
            ? Math.Abs(Math.Sqrt((p.X * p.X) + (p.Y * p.Y)) - 20)
            : Math.Min(new Vector3(p.X - 20, p.Y, 0).Length, new Vector3(p.X, p.Y - 20, 0).Length);
        return Math.Abs(foot.Distance - Math.Sqrt((across * across) + (beside * beside))) < 1e-11 && foot.Accuracy <= Tolerance;
    });

    [Fact]
    public void Distance_from_a_sphere_is_that_from_its_center_less_the_radius() => Draw.Law(
        Gen.Choose(1, 999).Two().Zip(Gen.Choose(15_000, 200_000)),
        c =>
        {
            var (around, up, r) = (c.Item1.Item1 / 1000.0 * Math.PI / 2, c.Item1.Item2 / 1000.0 * Math.PI / 2, c.Item2 / 1000.0);
            var p = new Point3(r * Math.Cos(around) * Math.Cos(up), r * Math.Sin(around) * Math.Cos(up), r * Math.Sin(up));
            var foot = Sphere.ClosestPoint(p);

            // Next to the pole, where one derivative vanishes, the search ends before it has proven as much as elsewhere, and says so.
            var proven = up > 0.99 * Math.PI / 2 ? 10 * Tolerance : Tolerance;
            return Math.Abs(foot.Distance - Math.Abs(r - 40)) < 1e-11 && foot.Accuracy <= proven;
        },
        100);

    [Fact]
    public void Points_on_a_surface_are_their_own_feet() => Draw.Law(Gen.Choose(0, 1000).Two(), c =>
    {
        var (u, v) = (75 * c.Item1 / 1000.0, 63 * c.Item2 / 1000.0);
        var foot = Waves.ClosestPoint(Waves.PointAt(u, v));
        return foot.Distance < 1e-12 && Math.Abs(foot.At.U - u) < 1e-9 && Math.Abs(foot.At.V - v) < 1e-9;
    });

    [Fact]
    public void Points_over_a_surface_stand_upright_at_their_foot() => Draw.Law(Gen.Choose(0, 1000).Two().Zip(Gen.Choose(-9000, 9000)), c =>
    {
        // Its smallest radius of curvature is over 20 mm.
        var (u, v, height) = (75 * c.Item1.Item1 / 1000.0, 63 * c.Item1.Item2 / 1000.0, c.Item2 / 1000.0);
        var at = Waves.At(u, v);
        var foot = Waves.ClosestPoint(at.Position + (at.Normal * height));

        // A distance is flat at its foot: where it no longer falls, the place is known to the root of its rounding. 1 of 100,000 points is
        // 0.14 nm off so.
        return Math.Abs(foot.Height - height) < 1e-11
            && foot.OffNormal < 1e-6
            && Math.Abs(foot.At.U - u) < 1e-6
            && Math.Abs(foot.At.V - v) < 1e-6;
    });

    [Fact]
    public void No_place_of_a_dense_grid_is_closer() => Draw.Law(
        DrawSpline.Surface.Zip(Near),
        c =>
        {
            var (surface, p) = c;
            var foot = surface.ClosestPoint(p);
            var least = double.PositiveInfinity;
            for (var i = 0; i <= 60; i++)
            {
                for (var j = 0; j <= 60; j++)
                {
                    least = Math.Min(
                        least,
                        (
                            surface.PointAt(
                                DrawSpline.Inside(surface.KnotsU, (i / 30.0) - 1), DrawSpline.Inside(surface.KnotsV, (j / 30.0) - 1)) - p)
                            .Length);
                }
            }

            return foot.Distance <= least + 1e-10
                && (surface.PointAt(foot.At.U, foot.At.V) - foot.At.Position).Length < 1e-9
                && foot.Accuracy <= Tolerance;
        },
        60);

    [Fact]
    public void A_hint_on_the_wrong_hill_does_not_mislead() => Draw.Law(Near.Zip(Gen.Choose(0, 75).Zip(Gen.Choose(0, 63))), c =>
    {
        var (p, hint) = c;
        var (with, without) = (Waves.ClosestPoint(p, hint.Item1, hint.Item2), Waves.ClosestPoint(p));
        return Math.Abs(with.Distance - without.Distance) < Tolerance;
    });

    [Fact]
    public void Center_of_a_sphere_says_what_accuracy_it_reached()
    {
        var foot = Sphere.ClosestPoint(default);
        Assert.Equal(40, foot.Distance, 1e-10);
        Assert.InRange(foot.Accuracy, 1e-7, 0.1);
    }

    [Fact]
    public void Foot_beyond_an_edge_is_on_it_and_not_upright()
    {
        var foot = Plane.ClosestPoint(new(80, 30, 2));
        Assert.Equal((75.0, 30.0), (foot.At.Position.X, foot.At.Position.Y));
        Assert.Equal(5, foot.OffNormal, 1e-12);
        Assert.Equal(2, foot.Height, 1e-12);
    }

    [Fact]
    public void Crease_is_found()
    {
        // A roof: degree 1 with its ridge at x = 10.
        var roof = new SplineSurface(
            KnotVector.Clamped(1, [0, 10, 20]),
            KnotVector.Clamped(1, [0, 30]),
            [new(0, 0, 0), new(0, 30, 0), new(10, 0, 5), new(10, 30, 5), new(20, 0, 0), new(20, 30, 0)]);
        var foot = roof.ClosestPoint(new(10.5, 12, 9));
        Assert.Equal(new Point3(10, 12, 5), foot.At.Position);
        Assert.True(foot.Accuracy <= Tolerance);
    }

    [Theory]
    [InlineData(0, 1e-9)]
    [InlineData(1e-15, 1e-9)]
    [InlineData(1e-14, 1e-9)]
    [InlineData(1e-13, 1e-10)]
    [InlineData(1e-12, 1e-10)]
    public void Corner_is_found_from_beside_it_also_where_parameters_are_oblique(double besideU, double besideV)
    {
        // The lines of the parameters cross at 26 degrees: in the corner the distance falls along both,
        // but Newton's step goes back along v.
        var oblique = new SplineSurface(
            KnotVector.Clamped(1, [0, 1]), KnotVector.Clamped(1, [0, 1]), [new(0, 0, 0), new(90, 44, 0), new(100, 0, 0), new(190, 44, 0)]);
        var corner = new Point3(190, 44, 0);
        var p = corner + (new Vector3(0.5, -0.9, 0) * 40) + new Vector3(0, 0, 30);
        Assert.True((p - corner).Dot(new(100, 0, 0)) > 0 && (p - corner).Dot(new(90, 44, 0)) > 0);
        var foot = oblique.ClosestPoint(p, 1 - besideU, 1 - besideV);
        Assert.Equal((1.0, 1.0), (foot.At.U, foot.At.V));
    }

    [Fact]
    public void What_is_no_point_is_refused()
    {
        Refused.With(GeometryError.NotFinite, () => Plane.ClosestPoint(new(double.NaN, 0, 0)));
        Refused.With(GeometryError.NotFinite, () => Plane.ClosestPoint(default, 0));
        Refused.With(GeometryError.NotFinite, () => Plane.ClosestPoint(default, double.PositiveInfinity, 0));
    }
}
