namespace ErrorMatching.Geometry;

/// <summary>Spline surfaces through points, or near them by least squares. In grids of points and poles, v varies fastest.</summary>
public static partial class SplineSurfaceFit
{
    /// <summary>The surface through every point of a grid, with mean chord length parameters and averaged knots (The NURBS Book, section
    /// 9.2.5).</summary>
    /// <param name="points">The points, v varying fastest.</param>
    /// <param name="countU">Points along u, at least two.</param>
    /// <param name="countV">Points along v, at least two.</param>
    /// <param name="degreeU">The highest degree along u; lower if there are too few points.</param>
    /// <param name="degreeV">The highest degree along v; lower if there are too few points.</param>
    /// <exception cref="GeometryException">The points do not determine a surface.</exception>
    public static SplineSurface Interpolate(ReadOnlySpan<Point3> points, int countU, int countV, int degreeU = 3, int degreeV = 3)
    {
        var (us, vs) = SplineParameters.OfGrid(points, countU, countV);
        return Interpolate(points, us, vs, degreeU, degreeV);
    }

    /// <summary>The surface through every point of a grid at given parameters.</summary>
    /// <param name="points">The points, v varying fastest.</param>
    /// <param name="us">Ascending parameters along u.</param>
    /// <param name="vs">Ascending parameters along v.</param>
    /// <param name="degreeU">The highest degree along u; lower if there are too few points.</param>
    /// <param name="degreeV">The highest degree along v; lower if there are too few points.</param>
    /// <exception cref="GeometryException">The parameters do not ascend or match the points, or a coordinate is not finite.</exception>
    public static SplineSurface Interpolate(
        ReadOnlySpan<Point3> points, ReadOnlySpan<double> us, ReadOnlySpan<double> vs, int degreeU = 3, int degreeV = 3) =>
        LeastSquares(
        points,
        us,
        vs,
        FittingKnots.ForInterpolation(Math.Min(degreeU, us.Length - 1), us),
        FittingKnots.ForInterpolation(Math.Min(degreeV, vs.Length - 1), vs));

    /// <summary>The surface with given knots and the least sum of squared distances between the points of a grid and the surface at their
    /// parameters. All lines are fitted along u, then along v.</summary>
    /// <param name="points">The points, v varying fastest.</param>
    /// <param name="us">Ascending parameters along u.</param>
    /// <param name="vs">Ascending parameters along v.</param>
    /// <param name="knotsU">Degree and knots along u.</param>
    /// <param name="knotsV">Degree and knots along v.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.RankDeficient"/> if the points do not determine every pole
    /// (<see cref="FittingKnots.Determine"/>); the parameters do not ascend or match the points; a coordinate is not finite.</exception>
    public static SplineSurface LeastSquares(
        ReadOnlySpan<Point3> points, ReadOnlySpan<double> us, ReadOnlySpan<double> vs, KnotVector knotsU, KnotVector knotsV)
    {
        ArgumentNullException.ThrowIfNull(knotsU);
        ArgumentNullException.ThrowIfNull(knotsV);
        SplineParameters.CheckRising(us, us.Length);
        SplineParameters.CheckRising(vs, vs.Length);
        if (points.Length != us.Length * vs.Length)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{points.Length} points for {us.Length} x {vs.Length} parameters");
        }

        var alongU = LinePass.Fit(knotsU, us, LinePass.Numbers(points), 3 * vs.Length);
        var byV = LinePass.Transposed(alongU, knotsU.PoleCount, vs.Length);
        var alongV = LinePass.Fit(knotsV, vs, byV, 3 * knotsU.PoleCount);
        return new(knotsU, knotsV, LinePass.Points(LinePass.Transposed(alongV, knotsV.PoleCount, knotsU.PoleCount)));
    }

    /// <summary>The least-squares surface for scattered points with individual parameters.</summary>
    /// <param name="points">The points in any order.</param>
    /// <param name="us">One parameter u per point.</param>
    /// <param name="vs">One parameter v per point.</param>
    /// <param name="knotsU">Degree and knots along u.</param>
    /// <param name="knotsV">Degree and knots along v.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.RankDeficient"/> if the points do not determine every pole; the counts
    /// differ; a number is not finite.</exception>
    public static SplineSurface LeastSquaresScattered(
        ReadOnlySpan<Point3> points, ReadOnlySpan<double> us, ReadOnlySpan<double> vs, KnotVector knotsU, KnotVector knotsV)
    {
        CheckScattered(points, us, vs, knotsU, knotsV);
        var (p, q, stride) = (knotsU.Degree, knotsV.Degree, knotsV.PoleCount);
        var equations = new BandedLeastSquares(knotsU.PoleCount * stride, (p * stride) + q + 1, 3);
        var factors = new double[(p * stride) + q + 1];
        var order = Enumerable.Range(0, points.Length).ToArray();
        // Equations are cheap in the order of their first pole.
        Array.Sort(FirstPoles(us, vs, knotsU, knotsV), order);
        Span<double> basisU = stackalloc double[p + 1];
        Span<double> basisV = stackalloc double[q + 1];
        Span<double> right = stackalloc double[3];
        foreach (var k in order)
        {
            var (spanU, spanV) = (knotsU.SpanAt(us[k]), knotsV.SpanAt(vs[k]));
            knotsU.Basis.WithDerivatives(spanU, us[k], 0, basisU);
            knotsV.Basis.WithDerivatives(spanV, vs[k], 0, basisV);
            Array.Clear(factors);
            for (var i = 0; i <= p; i++)
            {
                for (var j = 0; j <= q; j++)
                {
                    factors[(i * stride) + j] = basisU[i] * basisV[j];
                }
            }

            (right[0], right[1], right[2]) = (points[k].X, points[k].Y, points[k].Z);
            equations.Add(((spanU - p) * stride) + spanV - q, factors, right);
        }

        return new(knotsU, knotsV, LinePass.Points(equations.Solve()));
    }

    private static int[] FirstPoles(ReadOnlySpan<double> us, ReadOnlySpan<double> vs, KnotVector knotsU, KnotVector knotsV)
    {
        var first = new int[us.Length];
        for (var k = 0; k < first.Length; k++)
        {
            first[k] = ((knotsU.SpanAt(us[k]) - knotsU.Degree) * knotsV.PoleCount) + knotsV.SpanAt(vs[k]) - knotsV.Degree;
        }

        return first;
    }

    private static void CheckScattered(
        ReadOnlySpan<Point3> points, ReadOnlySpan<double> us, ReadOnlySpan<double> vs, KnotVector knotsU, KnotVector knotsV)
    {
        ArgumentNullException.ThrowIfNull(knotsU);
        ArgumentNullException.ThrowIfNull(knotsV);
        if (us.Length != points.Length || vs.Length != points.Length)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{us.Length} and {vs.Length} parameters for {points.Length} points");
        }

        for (var i = 0; i < points.Length; i++)
        {
            if (!points[i].IsFinite || !double.IsFinite(us[i]) || !double.IsFinite(vs[i]))
            {
                throw new GeometryException(
                    GeometryError.NotFinite, $"point {i + 1} has a coordinate or a parameter that is no finite number");
            }
        }
    }
}
