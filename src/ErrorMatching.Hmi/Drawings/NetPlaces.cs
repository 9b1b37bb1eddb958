using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Places between those of a net: found under a point seen from above, and interpolated in their cell.</summary>
internal static class NetPlaces
{
    // Newton's method on a cell that is nearly a parallelogram ends after three steps.
    private const int MostSteps = 12;

    // Share of a cell that rounding takes a place on its border out of it.
    private const double RoundingShare = 1e-9;

    /// <summary>The place of the net under a point seen from above, counted in cells along u and v; null if it is not on
    /// the piece.</summary>
    public static (double U, double V)? Under(SurfaceNet net, Point2 at)
    {
        ArgumentNullException.ThrowIfNull(net);
        var outside = net.Outside.ToHashSet();
        for (var cell = 0; cell < (net.CountU - 1) * (net.CountV - 1); cell++)
        {
            if (!outside.Contains(cell) && In(net, cell / (net.CountV - 1), cell % (net.CountV - 1), at) is { } found)
            {
                return found;
            }
        }

        return null;
    }

    /// <summary>The position of a place of the net.</summary>
    public static Point3 PositionAt(SurfaceNet net, double u, double v)
    {
        var position = At(net, u, v, p => net.Places[p] - default(Point3), (a, b, share) => a + ((b - a) * share));
        return default(Point3) + position;
    }

    /// <summary>The value at a place of the net, interpolated between its four neighbors.</summary>
    public static double ValueAt(SurfaceNet net, IReadOnlyList<double> values, double u, double v) =>
        At(net, u, v, p => values[p], (a, b, share) => a + ((b - a) * share));

    private static T At<T>(SurfaceNet net, double u, double v, Func<int, T> of, Func<T, T, double, T> between)
    {
        var (i, j) = (Math.Clamp((int)Math.Floor(u), 0, net.CountU - 2), Math.Clamp((int)Math.Floor(v), 0, net.CountV - 2));
        return between(
            between(of((i * net.CountV) + j), of(((i + 1) * net.CountV) + j), u - i),
            between(of((i * net.CountV) + j + 1), of(((i + 1) * net.CountV) + j + 1), u - i),
            v - j);
    }

    private static (double U, double V)? In(SurfaceNet net, int i, int j, Point2 at)
    {
        Point2 Corner(int du, int dv) => net.Places[((i + du) * net.CountV) + j + dv] is var p ? new(p.X, p.Y) : default;
        var (a, b, c, d) = (Corner(0, 0), Corner(1, 0), Corner(1, 1), Corner(0, 1));
        if (!PlotBox.Of([a, b, c, d]).Contains(at))
        {
            return null;
        }

        var (u, v) = (0.5, 0.5);
        for (var step = 0; step < MostSteps; step++)
        {
            var (low, high) = (a.Lerp(b, u), d.Lerp(c, u));
            var (alongU, alongV, off) = ((b - a) + (((c - d) - (b - a)) * v), high - low, at - low.Lerp(high, v));
            var area = alongU.Cross(alongV);
            if (area == 0)
            {
                return null;
            }

            (u, v) = (u + (off.Cross(alongV) / area), v + (alongU.Cross(off) / area));
        }

        return u is >= -RoundingShare and <= 1 + RoundingShare && v is >= -RoundingShare and <= 1 + RoundingShare
            ? (i + Math.Clamp(u, 0, 1), j + Math.Clamp(v, 0, 1))
            : null;
    }
}
