using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Builds the region of a B-spline surface from its boundary polygons.</summary>
internal static class RegionLimits
{
    private const double WholeShare = 1e-4;

    /// <summary>Returns the region inside polygons; the whole surface if they are only its own border.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="loops">The polygons.</param>
    /// <param name="fail">Creates an error from a code and a problem.</param>
    /// <exception cref="InputException">A polygon leaves the surface, or they cross, or are not an outer one with holes.</exception>
    public static SurfaceRegion Of(
        SplineSurface surface, IReadOnlyList<IReadOnlyList<Point2>> loops, Func<string, string, InputException> fail)
    {
        var seam = SurfaceSeam.Find(surface);
        var inside = loops.Select(
            l => (IReadOnlyList<Point2>)[
                .. (seam.Within(surface, l) ?? throw Crossing(surface, l, fail)).Select(q => Clamp(surface, q, fail))]).ToList();
        if (inside.Count == 0 || (inside is [var only] && IsBorder(surface, only)))
        {
            return SurfaceRegion.Whole;
        }

        new LoopNesting(surface, inside, fail).Check();
        return new(inside);
    }

    public static IReadOnlyList<Point2> Border(SplineSurface surface)
    {
        var (u, v) = (surface.KnotsU, surface.KnotsV);
        return [new(u.Start, v.Start), new(u.End, v.Start), new(u.End, v.End), new(u.Start, v.End)];
    }

    private static InputException Crossing(
        SplineSurface surface, IReadOnlyList<Point2> loop, Func<string, string, InputException> fail)
    {
        var at = SurfaceSeam.Find(surface).Within(surface, loop[0]);
        var p = surface.PointAt(at.X, at.Y);
        return fail(
            "bad-loop",
            $"the limits, one of them through {PlaceText.Triple(p)}, cross the line where the surface closes on itself. Export the part "
                + $"that is cut as a surface of its own, or turn that line to its other side");
    }

    private static Point2 Clamp(SplineSurface surface, Point2 q, Func<string, string, InputException> fail)
    {
        var (u, v) = (surface.KnotsU, surface.KnotsV);
        Point2 held = new(Math.Clamp(q.X, u.Start, u.End), Math.Clamp(q.Y, v.Start, v.End));
        return held == q || (surface.PointAt(held.X, held.Y) - surface.PointAt(q.X, q.Y)).Length <= RegionTracer.GapMm ? held
            : throw fail(
                "limit-off-surface",
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"a curve that limits the surface goes to ({q.X:0.######}, {q.Y:0.######}) of its parameters, which end at "
                        + $"{u.Start:0.######}..{u.End:0.######} and {v.Start:0.######}..{v.End:0.######}"));
    }

    // All points are on the border and the whole area is inside: the surface is not trimmed.
    private static bool IsBorder(SplineSurface surface, IReadOnlyList<Point2> loop)
    {
        var (u, v) = (surface.KnotsU, surface.KnotsV);
        var (width, height) = (u.End - u.Start, v.End - v.Start);
        return Math.Abs(RegionLoop.Area(loop)) >= (1 - WholeShare) * width * height && loop.All(q =>
        {
            Point2[] snapped = [new(u.Start, q.Y), new(u.End, q.Y), new(q.X, v.Start), new(q.X, v.End)];
            var nearest = snapped.MinBy(s => (Math.Abs(s.X - q.X) / width) + (Math.Abs(s.Y - q.Y) / height));
            return (surface.PointAt(nearest.X, nearest.Y) - surface.PointAt(q.X, q.Y)).Length <= RegionTracer.ToleranceMm;
        });
    }
}
