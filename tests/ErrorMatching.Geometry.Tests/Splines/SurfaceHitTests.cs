using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SurfaceHitTests
{
    private static readonly Gen<Vector3> Direction = Gen.Choose(-1000, 1000)
        .Three()
        .Where(c => c.Item1 != 0 || c.Item2 != 0 || c.Item3 != 0)
        .Select(c => new Vector3(c.Item1, c.Item2, c.Item3).Normalize());

    private static readonly SplineSurface Sphere = Shapes.Sphere(40);
    private static readonly SplineSurface Waves = Shapes.Waves();

    [Fact]
    public void Line_meets_a_sphere_where_the_quadratic_equation_says() => Draw.Law(
        Draw.Coordinate.Three().Zip(Direction),
        c =>
        {
            var (from, d) = (new Point3(0.5 * c.Item1.Item1, 0.5 * c.Item1.Item2, 0.5 * c.Item1.Item3), c.Item2);
            var o = from - default(Point3);
            var (b, rest) = (o.Dot(d), o.Dot(o) - 1600);
            var under = (b * b) - rest;
            double[] roots = under < 0 ? [] : [-b - Math.Sqrt(under), -b + Math.Sqrt(under)];
            var expected = roots.Where(t => Least(from + (d * t)) > 0).ToArray();

            // Nearly tangent to the sphere or nearly through the rim of the eighth, rounding decides.
            if (Math.Abs(under) < 1e-3 || roots.Any(t => Math.Abs(Least(from + (d * t))) < 1e-6))
            {
                return true;
            }

            var hits = Sphere.Hits(from, d * 7);
            return hits.Count == expected.Length && hits.Zip(expected).All(p => Math.Abs(p.First.Along - p.Second) < 1e-9);
        });

    [Fact]
    public void Line_through_a_place_hits_it() => Draw.Law(
        Gen.Choose(0, 1000).Two().Zip(Direction),
        c =>
        {
            var at = Waves.At(75 * c.Item1.Item1 / 1000.0, 63 * c.Item1.Item2 / 1000.0);
            if (Math.Abs(at.Normal.Dot(c.Item2)) < 0.01)
            {
                return true;
            }

            var hits = Waves.Hits(at.Position + (c.Item2 * -30), c.Item2);
            return hits.Any(h => Math.Abs(h.Along - 30) < 1e-9 && Math.Abs(h.At.U - at.U) < 1e-8 && Math.Abs(h.At.V - at.V) < 1e-8)
                && hits.All(h => (h.At.Position - (at.Position + (c.Item2 * (h.Along - 30)))).Length < 1e-9);
        },
        300);

    [Fact]
    public void Vertical_line_meets_the_waves_once_and_a_level_line_many_times()
    {
        Assert.Single(Waves.Hits(new(31, 17, 100), new(0, 0, -1)));
        var hits = Waves.Hits(new(0, 9 * Math.PI / 2, 0.1), new(1, 0, 0));

        // Over 75 mm the sine of 12 mm rises or falls through one height twice, and the poles' surface follows it.
        Assert.Equal(2, hits.Count);
        Assert.All(hits, h => Assert.Equal(0.1, h.At.Position.Z, 1e-9));
    }

    [Fact]
    public void Line_that_touches_a_sphere_has_one_hit()
    {
        var d = new Vector3(1, -1, 0).Normalize();
        var top = new Point3(40 * Math.Sqrt(1 / 3.0), 40 * Math.Sqrt(1 / 3.0), 40 * Math.Sqrt(1 / 3.0));
        var hit = Assert.Single(Sphere.Hits(top + (d * -5), d));
        Assert.Equal(5, hit.Along, 2e-3);
    }

    [Fact]
    public void Line_that_passes_by_has_none() => Assert.Empty(Waves.Hits(new(80, 17, 100), new(0, 0, 1)));

    [Fact]
    public void Line_along_a_surface_is_refused() =>
        Refused.With(GeometryError.NearParallel, () => Shapes.Plane(75, 63).Hits(new(1, 1, 0), new(1, 0.3, 0)));

    private static double Least(Point3 p) => Math.Min(p.X, Math.Min(p.Y, p.Z));
}
