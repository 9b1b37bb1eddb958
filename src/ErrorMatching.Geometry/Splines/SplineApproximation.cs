namespace ErrorMatching.Geometry;

/// <summary>A B-spline surface in place of a function of the same parameters.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="ErrorMm">The largest distance between surface and function at the same parameters, measured at 25 places in every cell between knots, in millimetres.</param>
public sealed record SplineApproximation(SplineSurface Surface, double ErrorMm)
{
    // Enough for a whole piece at 1 nm; a function with a break that is not among the knots stops here.
    private const int MostPoles = 400;
    private const double ShortestSpan = 1e-6;

    // Shares of a span at which the error is measured; the surface meets the function about once a span.
    private static readonly double[] Places = [0.1, 0.3, 0.5, 0.7, 0.9];

    /// <summary>The surface that meets a function at the Greville points of its knots, which are refined where it is farther away than wanted.</summary>
    /// <remarks>
    /// A function of a surface's normals is once less smooth than the surface: where its knots are breaks of such a function, begin with each of them once more often.
    /// In each direction the error is measured where the other direction is exact, so that only the direction that needs them gets knots. Where the wanted error is not reached with 400 poles along u or v,
    /// the best surface comes back with the error that it has.
    /// </remarks>
    /// <param name="function">The function; it is asked for places within the range of the knots.</param>
    /// <param name="u">The degree along u, the range, and the knots to begin with: a break of the function's derivatives is to be among them, as often as the derivatives break (degree times for a kink). None more than degree times.</param>
    /// <param name="v">The same along v.</param>
    /// <param name="toleranceMm">Largest error wanted, positive.</param>
    /// <exception cref="GeometryException">The tolerance is not positive, the function has a value that is not finite, or an inner knot is repeated more often than its degree.</exception>
    public static SplineApproximation Of(Func<double, double, Point3> function, KnotVector u, KnotVector v, double toleranceMm)
    {
        ArgumentNullException.ThrowIfNull(function);
        ArgumentNullException.ThrowIfNull(u);
        ArgumentNullException.ThrowIfNull(v);
        if (!(toleranceMm > 0))
        {
            throw new GeometryException(GeometryError.NotFinite, "the tolerance of an approximation is not positive");
        }

        (u, v) = (u.Clamp(), v.Clamp());
        while (true)
        {
            var (nodesU, nodesV) = (Nodes(u), Nodes(v));
            var surface = Through(function, u, v, nodesU, nodesV);
            var (finerU, finerV) = (
                Refine(u, t => nodesV.Max(n => Apart(function, surface, t, n)), toleranceMm / 3),
                Refine(v, t => nodesU.Max(n => Apart(function, surface, n, t)), toleranceMm / 3));
            if (finerU is null && finerV is null)
            {
                var placesV = PlacesOf(v);
                var worst = 0.0;
                finerU = Refine(u, t => placesV.Max(n => Apart(function, surface, t, n)), toleranceMm, e => worst = Math.Max(worst, e));
                if (finerU is null)
                {
                    return new(surface, worst);
                }
            }

            (u, v) = (finerU ?? u, finerV ?? v);
        }
    }

    private static double[] Nodes(KnotVector knots) => [.. Enumerable.Range(0, knots.PoleCount).Select(knots.Greville)];

    private static double[] PlacesOf(KnotVector knots)
    {
        var breaks = knots.Breaks;
        return [.. Enumerable.Range(1, breaks.Count - 1).SelectMany(i => Places.Select(x => breaks[i - 1] + (x * (breaks[i] - breaks[i - 1]))))];
    }

    private static double Apart(Func<double, double, Point3> function, SplineSurface surface, double u, double v) => (function(u, v) - surface.PointAt(u, v)).Length;

    private static SplineSurface Through(Func<double, double, Point3> function, KnotVector u, KnotVector v, double[] nodesU, double[] nodesV)
    {
        var points = new Point3[nodesU.Length * nodesV.Length];
        for (var i = 0; i < points.Length; i++)
        {
            points[i] = function(nodesU[i / nodesV.Length], nodesV[i % nodesV.Length]);
            if (!points[i].IsFinite)
            {
                throw new GeometryException(GeometryError.NotFinite, FormattableString.Invariant($"the function has no finite value at u = {nodesU[i / nodesV.Length]}, v = {nodesV[i % nodesV.Length]}"));
            }
        }

        return SplineSurface.AtGreville(u, v, points);
    }

    /// <summary>The knots with one more in the middle of every span in which the error is too large; null if there is none, or no room for them.</summary>
    private static KnotVector? Refine(KnotVector knots, Func<double, double> error, double tolerance, Action<double>? seen = null)
    {
        var breaks = knots.Breaks;
        var added = new List<double>();
        for (var i = 1; i < breaks.Count; i++)
        {
            var (from, span) = (breaks[i - 1], breaks[i] - breaks[i - 1]);
            var worst = Places.Max(x => error(from + (x * span)));
            seen?.Invoke(worst);
            if (worst > tolerance && span > ShortestSpan * (knots.End - knots.Start))
            {
                added.Add(from + (0.5 * span));
            }
        }

        return added.Count == 0 || knots.PoleCount + added.Count > MostPoles ? null : new(knots.Degree, [.. knots.Values.ToArray().Concat(added).Order()]);
    }
}
