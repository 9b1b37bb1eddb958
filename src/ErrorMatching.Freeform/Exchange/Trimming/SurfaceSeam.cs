using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Where a B-spline surface closes on itself, such as a surface of revolution. Places on both sides of the seam coincide, so a
/// boundary that ends at it must not return from the other side.</summary>
/// <param name="PeriodU">Period of u if the surface is closed along u, otherwise 0.</param>
/// <param name="PeriodV">The same along v.</param>
internal readonly record struct SurfaceSeam(double PeriodU, double PeriodV)
{
    private const double ClosedMm = RegionTracer.ToleranceMm;
    private const int Places = 8;

    /// <summary>Share of a period by which rounding may move a loop beyond the ends.</summary>
    private const double Slack = 1e-6;

    public static SurfaceSeam Find(SplineSurface surface)
    {
        var (u, v) = (surface.KnotsU, surface.KnotsV);
        return new(
            IsOne(v, t => surface.PointAt(u.Start, t), t => surface.PointAt(u.End, t)) ? u.End - u.Start : 0,
            IsOne(u, t => surface.PointAt(t, v.Start), t => surface.PointAt(t, v.End)) ? v.End - v.Start : 0);
    }

    /// <summary>The same place, shifted by whole periods to be closest to another one.</summary>
    public Point2 Beside(Point2 q, Point2 other) => new(Turned(q.X, other.X, PeriodU), Turned(q.Y, other.Y, PeriodV));

    /// <summary>The same place within the parameter range of the surface.</summary>
    public Point2 Within(SplineSurface surface, Point2 q) =>
        new(Wrapped(q.X, surface.KnotsU, PeriodU), Wrapped(q.Y, surface.KnotsV, PeriodV));

    /// <summary>True if two places, one on the surface, are separated by whole periods.</summary>
    public bool IsBetween(Point2 a, Point2 b) => Beside(a, b) != a;

    /// <summary>Shifts a loop by whole periods into the parameter range of the surface.</summary>
    /// <returns>Null if it crosses the seam.</returns>
    public IReadOnlyList<Point2>? Within(SplineSurface surface, IReadOnlyList<Point2> loop)
    {
        if (Shift(loop.Min(q => q.X), loop.Max(q => q.X), surface.KnotsU, PeriodU) is not { } x
            || Shift(loop.Min(q => q.Y), loop.Max(q => q.Y), surface.KnotsV, PeriodV) is not { } y)
        {
            return null;
        }

        return (x, y) == (0, 0) ? loop : [.. loop.Select(q => new Point2(q.X + x, q.Y + y))];
    }

    // True if both ends are the same line over its full length.
    private static bool IsOne(KnotVector along, Func<double, Point3> first, Func<double, Point3> last) =>
        Enumerable.Range(0, Places + 1)
            .Select(i => along.Start + ((along.End - along.Start) * i / Places))
            .All(t => (last(t) - first(t)).Length <= ClosedMm);

    private static double Turned(double value, double other, double period) =>
        period > 0 ? value + (period * Math.Round((other - value) / period)) : value;

    private static double Wrapped(double value, KnotVector knots, double period) =>
        period > 0 && (value < knots.Start || value > knots.End)
            ? knots.Start + (value - knots.Start - (period * Math.Floor((value - knots.Start) / period)))
            : value;

    private static double? Shift(double least, double most, KnotVector knots, double period)
    {
        if (period == 0)
        {
            return 0;
        }

        var turns = period * -Math.Floor(((least - knots.Start) / period) + Slack);
        return most + turns <= knots.End + (Slack * period) ? turns : null;
    }
}
