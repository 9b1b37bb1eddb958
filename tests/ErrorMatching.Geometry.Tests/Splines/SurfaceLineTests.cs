using System.Runtime.Intrinsics;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SurfaceLineTests
{
    [Fact]
    public void Line_of_a_quadratic_surface_has_the_derivatives_of_its_formula()
    {
        // x = 10 u, y = 8 v, z = 3 u^2 - 2 u v + v^2, poles by blossoming each monomial.
        var line = new SurfaceLine(new(
            new(2, [0, 0, 0, 1, 1, 1]),
            new(2, [0, 0, 0, 1, 1, 1]),
            [
                new(0, 0, 0), new(0, 4, 0), new(0, 8, 1), new(5, 0, 0), new(5, 4, -0.5), new(5, 8, 0), new(10, 0, 3), new(10, 4, 2),
                new(10, 8, 2)]));
        foreach (var (u, v) in new[] { (0.3, 0.8), (0.5, 0.8), (0.5, 0.1), (0, 0), (1, 1), (1.2, -0.1) })
        {
            line.At(u, v, out var position, out var du, out var dv);
            Near(new(10 * u, 8 * v, (3 * u * u) - (2 * u * v) + (v * v)), position, 1e-13);
            Near(new(10, 0, (6 * u) - (2 * v)), du, 1e-13);
            Near(new(0, 8, (-2 * u) + (2 * v)), dv, 1e-13);
            line.At(u, v, out _, out _, out _, out var duu, out var duv);
            Near(new(0, 0, 6), duu, 1e-12);
            Near(new(0, 0, -2), duv, 1e-12);
        }
    }

    [Fact]
    public void Line_says_the_same_as_the_surface_in_any_order_of_places() =>
        FsCheck.Check.QuickThrowOnFailure(Prop.ForAll(DrawSpline.Surface.Zip(Gen.Choose(0, 1_000_000)).ToArbitrary(), drawn =>
    {
        var (surface, seed) = drawn;
        var line = new SurfaceLine(surface);
        var noise = Draw.Noise(seed, 24);
        for (var i = 0; i < 20; i++)
        {
            // Every other place lies on the line of the one before, and some lie on knots.
            var v = DrawSpline.Inside(surface.KnotsV, noise[i - (i % 2)]);
            var u = i % 5 == 4 ? surface.KnotsU.Breaks[i % surface.KnotsU.Breaks.Count] : DrawSpline.Inside(surface.KnotsU, noise[i]);
            var at = surface.At(u, v);
            line.At(u, v, out var position, out var du, out var dv);
            var scale = 1e-11 * (1000 + at.Du.Length + at.Dv.Length);
            Near(new(at.Position.X, at.Position.Y, at.Position.Z), position, scale);
            Near(at.Du, du, scale);
            Near(at.Dv, dv, scale);
            line.At(u, v, out position, out du, out dv, out var duu, out var duv);
            scale += 1e-10 * (at.Duu.Length + at.Duv.Length);
            Near(new(at.Position.X, at.Position.Y, at.Position.Z), position, scale);
            Near(at.Du, du, scale);
            Near(at.Dv, dv, scale);
            Near(at.Duu, duu, scale);
            Near(at.Duv, duv, scale);
        }
    }));

    [Fact]
    public void Four_places_come_out_as_one_by_one() =>
        FsCheck.Check.QuickThrowOnFailure(Prop.ForAll(DrawSpline.Surface.Zip(Gen.Choose(0, 1_000_000)).ToArbitrary(), drawn =>
    {
        var (surface, seed) = drawn;
        var (line, other) = (new SurfaceLine(surface), new SurfaceLine(surface));
        var noise = Draw.Noise(seed, 20);
        for (var i = 0; i + 4 < noise.Length; i++)
        {
            // Near each other, so that they lie over one span, or anywhere; the last is a knot.
            var v = DrawSpline.Inside(surface.KnotsV, noise[i]);
            var spread = i % 2 == 0 ? 0.01 : 1;
            var u = Vector256.Create(
                DrawSpline.Inside(surface.KnotsU, noise[1]),
                DrawSpline.Inside(surface.KnotsU, noise[1] + (spread * (noise[i + 2] - noise[1]))),
                DrawSpline.Inside(surface.KnotsU, noise[1] + (spread * (noise[i + 3] - noise[1]))),
                i % 3 == 0 ? surface.KnotsU.Breaks[i % surface.KnotsU.Breaks.Count] : DrawSpline.Inside(surface.KnotsU, noise[1]));
            line.At(u, v, out var positions, out var du, out var dv);
            for (var k = 0; k < 4; k++)
            {
                other.At(u[k], v, out var position, out var itsDu, out var itsDv);
                Assert.Equal((position, itsDu, itsDv), (positions[k], du[k], dv[k]));
            }
        }
    }));

    [Fact]
    public void High_degrees_are_evaluated_by_the_surface_itself()
    {
        var knots = KnotVector.Clamped(12, [0, 1]);
        var surface = new SplineSurface(
            knots,
            KnotVector.Clamped(1, [0, 1]),
            [.. from i in Enumerable.Range(0, 13) from j in Enumerable.Range(0, 2) select new Point3(i, j, i * j)]);
        var line = new SurfaceLine(surface);
        line.At(0.25, 0.5, out var position, out var du, out var dv);
        Near(new(3, 0.5, 1.5), position, 1e-13);
        Near(new(12, 0, 6), du, 1e-12);
        Near(new(0, 1, 3), dv, 1e-12);
        line.At(Vector256.Create(0.25, 0.5, 0.75, 1), 0.5, out var positions, out var slopes, out _);
        Near(new(3, 0.5, 1.5), positions[0], 1e-13);
        Near(new(12, 0.5, 6), positions[3], 1e-13);
        Near(new(12, 0, 6), slopes[2], 1e-12);
        line.At(0.25, 0.5, out _, out _, out _, out var duu, out var duv);
        Near(Vector3.Zero, duu, 1e-9);
        Near(new(0, 0, 12), duv, 1e-11);
    }

    private static void Near(Vector3 expected, Vector3 actual, double tolerance) =>
        Assert.True((expected - actual).Length <= tolerance, $"{actual}, {expected} expected");
}
