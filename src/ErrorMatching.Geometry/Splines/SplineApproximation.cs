using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A B-spline surface that approximates a function of the same parameters.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="ErrorMm">The largest distance between surface and function at the same parameters, measured at 25 places in every cell
/// between knots, in millimeters.</param>
public sealed record SplineApproximation(SplineSurface Surface, double ErrorMm)
{
    // Sufficient for a whole piece at 1 nm. Refinement stops here for a function with a break that is not among the knots.
    private const int MostPoles = 400;
    private const double ShortestSpan = 1e-6;

    // Shares of a span at which the error is measured. The surface meets the function about once per span.
    private static readonly double[] Places = [0.1, 0.3, 0.5, 0.7, 0.9];

    /// <summary>Interpolates a function at the Greville points of the knots, and refines the knots where the error is too large.</summary>
    /// <remarks>A function of a surface's normals is once less smooth than the surface. If the surface's knots are breaks of such a
    /// function, start with their multiplicity increased by one. The error in each direction is measured where the other direction is
    /// exact, so that only the direction that needs knots gets them. If the tolerance is not reached with 400 poles along u or v, the best
    /// surface is returned with its error.</remarks>
    /// <param name="function">The function; evaluated within the range of the knots.</param>
    /// <param name="u">The degree and range along u, and the initial knots. They must include breaks of the function's derivatives with
    /// the right multiplicity (the degree for a kink), at most the degree.</param>
    /// <param name="v">The same along v.</param>
    /// <param name="toleranceMm">Largest permitted error, positive.</param>
    /// <exception cref="GeometryException">The tolerance is not positive, a value of the function is not finite, or the multiplicity of an
    /// inner knot exceeds the degree.</exception>
    public static SplineApproximation Fit(Func<double, double, Point3> function, KnotVector u, KnotVector v, double toleranceMm)
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
        return [
            .. Enumerable.Range(1, breaks.Count - 1).SelectMany(i => Places.Select(
                x => breaks[i - 1] + (x * (breaks[i] - breaks[i - 1]))))];
    }

    private static double Apart(Func<double, double, Point3> function, SplineSurface surface, double u, double v) =>
        (function(u, v) - surface.PointAt(u, v)).Length;

    private static SplineSurface Through(
        Func<double, double, Point3> function, KnotVector u, KnotVector v, double[] nodesU, double[] nodesV)
    {
        var points = new Point3[nodesU.Length * nodesV.Length];
        for (var i = 0; i < points.Length; i++)
        {
            points[i] = function(nodesU[i / nodesV.Length], nodesV[i % nodesV.Length]);
            if (!points[i].IsFinite)
            {
                throw new GeometryException(
                    GeometryError.NotFinite,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"the function has no finite value at u = {nodesU[i / nodesV.Length]}, v = {nodesV[i % nodesV.Length]}"));
            }
        }

        return SplineSurface.AtGreville(u, v, points);
    }

    /// <summary>Inserts a knot in the middle of every span with too large an error; null if there is none, or no room.</summary>
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

        return added.Count == 0 || knots.PoleCount + added.Count > MostPoles
            ? null
            : new(knots.Degree, [.. knots.Values.ToArray().Concat(added).Order()]);
    }
}
