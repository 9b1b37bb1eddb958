namespace ErrorMatching.Geometry;

/// <summary>Spline curves through points, or near them by least squares.</summary>
public static class SplineCurveFit
{
    /// <summary>The curve through every point, with chord length parameters and averaged knots (The NURBS Book, section 9.2.1).</summary>
    /// <param name="points">At least two points in order; neighbors differ.</param>
    /// <param name="degree">The highest degree; lower if there are too few points.</param>
    /// <exception cref="GeometryException">The points do not determine a curve.</exception>
    public static SplineCurve Interpolate(ReadOnlySpan<Point3> points, int degree = 3) =>
        Interpolate(points, SplineParameters.ChordLength(points), degree);

    /// <summary>The curve through every point at given parameters.</summary>
    /// <param name="points">At least two points in order.</param>
    /// <param name="parameters">Ascending parameters, one per point.</param>
    /// <param name="degree">The highest degree; lower if there are too few points.</param>
    /// <exception cref="GeometryException">The parameters do not ascend, or a coordinate is not finite.</exception>
    public static SplineCurve Interpolate(ReadOnlySpan<Point3> points, ReadOnlySpan<double> parameters, int degree = 3) =>
        LeastSquares(points, parameters, FittingKnots.ForInterpolation(Math.Min(degree, parameters.Length - 1), parameters));

    /// <summary>The curve with given knots and the least sum of squared distances between points and curve at their parameters. With one
    /// pole per point, it passes through them.</summary>
    /// <param name="points">Points in order.</param>
    /// <param name="parameters">Ascending parameters, one per point.</param>
    /// <param name="knots">Degree and knots.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.RankDeficient"/> if the points do not determine every pole
    /// (<see cref="FittingKnots.Determine"/>); the parameters do not ascend; a coordinate is not finite.</exception>
    public static SplineCurve LeastSquares(ReadOnlySpan<Point3> points, ReadOnlySpan<double> parameters, KnotVector knots)
    {
        ArgumentNullException.ThrowIfNull(knots);
        SplineParameters.CheckRising(parameters, points.Length);
        return new(knots, LinePass.Points(LinePass.Fit(knots, parameters, LinePass.Numbers(points), 3)));
    }

    /// <summary>Fits several curves with common parameters in one solution, which is faster than separately.</summary>
    /// <param name="curves">The points of each curve in order, one per parameter.</param>
    /// <param name="parameters">Ascending parameters.</param>
    /// <param name="knots">Degree and knots.</param>
    /// <exception cref="GeometryException">As for one curve.</exception>
    public static IReadOnlyList<SplineCurve> LeastSquaresFamily(
        IReadOnlyList<Point3[]> curves, ReadOnlySpan<double> parameters, KnotVector knots)
    {
        ArgumentNullException.ThrowIfNull(curves);
        ArgumentNullException.ThrowIfNull(knots);
        foreach (var curve in curves)
        {
            SplineParameters.CheckRising(parameters, curve.Length);
        }

        var lines = LinePass.Numbers(curves.SelectMany(c => c).ToArray());
        var poles = LinePass.Fit(knots, parameters, LinePass.Transposed(lines, curves.Count, parameters.Length), 3 * curves.Count);
        var byCurve = LinePass.Points(LinePass.Transposed(poles, knots.PoleCount, curves.Count));
        return [
            .. Enumerable.Range(0, curves.Count).Select(j => new SplineCurve(knots, byCurve.AsSpan(j * knots.PoleCount, knots.PoleCount)))];
    }

    /// <summary>The curve with given knots that balances the points against its bending energy. The weight predicts left-out points
    /// best.</summary>
    /// <param name="points">At least two points in order.</param>
    /// <param name="parameters">Ascending parameters, one per point.</param>
    /// <param name="knots">Degree, at least 2, and knots.</param>
    /// <exception cref="GeometryException">The parameters do not ascend, a coordinate is not finite, or the degree is 1, which has no
    /// bending.</exception>
    public static SplineCurve Smooth(ReadOnlySpan<Point3> points, ReadOnlySpan<double> parameters, KnotVector knots)
    {
        ArgumentNullException.ThrowIfNull(knots);
        SplineParameters.CheckRising(parameters, points.Length);
        if (points.Length < 2)
        {
            throw new GeometryException(GeometryError.TooFewPoints, $"{points.Length} points; a curve needs at least two");
        }

        if (knots.Degree < 2)
        {
            throw new GeometryException(
                GeometryError.BadKnots, "a smoothed curve of degree 1; its degree must be at least 2, or there is no bending to weigh");
        }

        var p = knots.Degree;
        var fit = new PenalizedFit(knots.PoleCount, p);
        Span<double> basis = stackalloc double[3 * (p + 1)];
        for (var i = 0; i < points.Length; i++)
        {
            var span = knots.SpanAt(parameters[i]);
            knots.Basis.WithDerivatives(span, parameters[i], 0, basis);
            fit.AddPoint(span - p, basis[..(p + 1)], points[i]);
        }

        foreach (var (t, weight) in GaussPoints.Of(knots))
        {
            var span = knots.SpanAt(t);
            knots.Basis.WithDerivatives(span, t, 2, basis);
            fit.AddBending(span - p, basis[(2 * (p + 1))..], weight);
        }

        return new(knots, fit.Solve().Poles);
    }
}
