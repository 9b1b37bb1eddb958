using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The edges of a piece seen against z, and their bounds.</summary>
internal sealed class SurfaceOutline
{
    // Edges of the parameters' range are curves on the surface: points on each.
    private const int Steps = 48;

    /// <summary>The outline of a surface.</summary>
    public SurfaceOutline(PartSurface surface)
    {
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        IReadOnlyList<IReadOnlyList<Point2>> loops = surface.Region.IsWhole
            ? [[new(u.Start, v.Start), new(u.End, v.Start), new(u.End, v.End), new(u.Start, v.End)]]
            : surface.Region.Loops;
        var (longestU, longestV) = ((u.End - u.Start) / Steps, (v.End - v.Start) / Steps);
        Loops = [.. loops.Select(l => (IReadOnlyList<Point2>)[.. Divided(l, longestU, longestV).Select(p => Above(surface, p))])];
        (MinX, MaxX) = (Loops.Min(l => l.Min(p => p.X)), Loops.Max(l => l.Max(p => p.X)));
        (MinY, MaxY) = (Loops.Min(l => l.Min(p => p.Y)), Loops.Max(l => l.Max(p => p.Y)));
        IsWhole = surface.Region.IsWhole;
    }

    /// <summary>Closed polygons in millimeters, the last point joined to the first.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Loops { get; }

    /// <summary>True if the surface is not trimmed.</summary>
    public bool IsWhole { get; }

    /// <summary>The smallest x.</summary>
    public double MinX { get; }

    /// <summary>The largest x.</summary>
    public double MaxX { get; }

    /// <summary>The smallest y.</summary>
    public double MinY { get; }

    /// <summary>The largest y.</summary>
    public double MaxY { get; }

    private static IEnumerable<Point2> Divided(IReadOnlyList<Point2> loop, double longestU, double longestV)
    {
        for (var k = 0; k < loop.Count; k++)
        {
            var (a, b) = (loop[k], loop[(k + 1) % loop.Count]);
            var parts = Math.Clamp(
                (int)Math.Ceiling(Math.Max(Math.Abs(b.X - a.X) / longestU, Math.Abs(b.Y - a.Y) / longestV) - 1e-9), 1, Steps);
            for (var i = 0; i < parts; i++)
            {
                yield return a + ((b - a) * ((double)i / parts));
            }
        }
    }

    private static Point2 Above(PartSurface surface, Point2 at)
    {
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        var p = surface.Spline.PointAt(Math.Clamp(at.X, u.Start, u.End), Math.Clamp(at.Y, v.Start, v.End));
        return new(p.X, p.Y);
    }
}
