using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>Spline surfaces through points, or near them by least squares. In grids of points and poles, v varies fastest.</summary>
public static class SplineSurfaceFit
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

    /// <summary>Skinning: the surface through curves along u, each at a parameter v, and as smooth between them as the degree allows (The
    /// NURBS Book, section 10.3).</summary>
    /// <param name="sections">At least two nonrational curves over the same parameters.</param>
    /// <param name="vs">Ascending parameters, one per curve; empty for the mean chord lengths between the curves' poles.</param>
    /// <param name="degreeV">The highest degree across the curves; lower if there are too few curves.</param>
    /// <exception cref="GeometryException">There are fewer than two curves, one is rational, their parameter ranges differ, or neighbors
    /// coincide.</exception>
    public static SplineSurface Skin(IReadOnlyList<SplineCurve> sections, ReadOnlySpan<double> vs = default, int degreeV = 3)
    {
        CheckFamily(sections);
        var curves = sections.All(s => s.Knots.Equals(sections[0].Knots)) ? sections : SplineCurve.Compatible(sections);
        var knotsU = curves[0].Knots;
        var poles = new Point3[knotsU.PoleCount * curves.Count];
        for (var j = 0; j < curves.Count; j++)
        {
            for (var i = 0; i < knotsU.PoleCount; i++)
            {
                poles[(i * curves.Count) + j] = curves[j].Poles[i];
            }
        }

        vs = vs.IsEmpty ? SplineParameters.OfGrid(poles, knotsU.PoleCount, curves.Count).V : vs;
        SplineParameters.CheckRising(vs, curves.Count);
        var knotsV = FittingKnots.ForInterpolation(Math.Min(degreeV, curves.Count - 1), vs);
        var byV = LinePass.Transposed(LinePass.Numbers(poles), knotsU.PoleCount, curves.Count);
        var alongV = LinePass.Fit(knotsV, vs, byV, 3 * knotsU.PoleCount);
        return new(knotsU, knotsV, LinePass.Points(LinePass.Transposed(alongV, knotsV.PoleCount, knotsU.PoleCount)));
    }

    /// <summary>The Gordon surface through a mesh of curves: the skin of the curves along u, plus the skin of those along v, minus the
    /// surface through their intersections (W. J. Gordon, "Spline-blended surface interpolation through curve networks", J. Math. Mech.
    /// 18, 1969; The NURBS Book, section 10.5).</summary>
    /// <param name="alongU">At least two nonrational curves along u over the same parameters; curve j is at vs[j].</param>
    /// <param name="vs">Ascending parameters of the curves along u, within the parameters of those along v.</param>
    /// <param name="alongV">At least two nonrational curves along v over the same parameters; curve i is at us[i].</param>
    /// <param name="us">Ascending parameters of the curves along v, within the parameters of those along u.</param>
    /// <param name="gapMm">Maximum distance between curves that should meet. The surface passes through both up to that gap.</param>
    /// <exception cref="GeometryException">As for <see cref="Skin"/>; or two curves that should meet are farther apart than the gap
    /// (<see cref="GeometryError.OpenMesh"/>).</exception>
    public static SplineSurface Gordon(
        IReadOnlyList<SplineCurve> alongU,
        ReadOnlySpan<double> vs,
        IReadOnlyList<SplineCurve> alongV,
        ReadOnlySpan<double> us,
        double gapMm)
    {
        CheckFamily(alongU);
        CheckFamily(alongV);
        SplineParameters.CheckRising(vs, alongU.Count);
        SplineParameters.CheckRising(us, alongV.Count);
        var meetings = new Point3[us.Length * vs.Length];
        for (var i = 0; i < us.Length; i++)
        {
            for (var j = 0; j < vs.Length; j++)
            {
                var (a, b) = (alongU[j].PointAt(us[i]), alongV[i].PointAt(vs[j]));
                var apart = (a - b).Length;
                if (!(apart <= gapMm))
                {
                    throw new GeometryException(
                        GeometryError.OpenMesh,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"curve {j + 1} along u and curve {i + 1} along v pass each other {apart:0.#####} mm apart; at most "
                                + $"{gapMm:0.#####} mm is expected where curves of a mesh meet"));
                }

                meetings[(i * vs.Length) + j] = a + ((b - a) * 0.5);
            }
        }

        var all = SplineSurface.Compatible([Skin(alongU, vs), Skin(alongV, us).Swap(), Interpolate(meetings, us, vs)]);
        var poles = new Point3[all[0].Poles.Length];
        for (var k = 0; k < poles.Length; k++)
        {
            poles[k] = all[0].Poles[k] + (all[1].Poles[k] - all[2].Poles[k]);
        }

        return new(all[0].KnotsU, all[0].KnotsV, poles);
    }

    private static void CheckFamily(IReadOnlyList<SplineCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(curves);
        if (curves.Count < 2)
        {
            throw new GeometryException(GeometryError.TooFewPoints, $"{curves.Count} curves; a surface through curves needs at least two");
        }

        if (curves.Any(c => c.IsRational))
        {
            throw new GeometryException(
                GeometryError.BadPoles, "a rational curve among those that a surface is to run through; fit it without weights first");
        }
    }

    /// <summary>The surface with given knots that balances points against the bending energy of a thin plate, for each coordinate: the
    /// integral of Suu^2 + 2 Suv^2 + Svv^2 over an area as large as the surface (J. Duchon 1977). Unless given, the weight of the energy
    /// predicts left-out points best (generalized cross-validation).</summary>
    /// <param name="points">At least three points in any order, on a grid or scattered.</param>
    /// <param name="us">One parameter u per point.</param>
    /// <param name="vs">One parameter v per point.</param>
    /// <param name="knotsU">Degree, at least 2, and knots along u. Time grows with the poles along u and the cube of those along v.</param>
    /// <param name="knotsV">Degree, at least 2, and knots along v.</param>
    /// <param name="lengthU">Length of the surface along u in mm, so that bending is that of the surface, not of its parameters.</param>
    /// <param name="lengthV">Length of the surface along v in mm.</param>
    /// <param name="weight">The weight in mm^2; null selects it.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.RankDeficient"/> if the points do not even determine a plane over the
    /// parameters; the counts differ; a number is not finite; a degree is below 2; a length is not positive.</exception>
    public static SmoothedSurface Smooth(
        ReadOnlySpan<Point3> points,
        ReadOnlySpan<double> us,
        ReadOnlySpan<double> vs,
        KnotVector knotsU,
        KnotVector knotsV,
        double lengthU,
        double lengthV,
        double? weight = null)
    {
        CheckScattered(points, us, vs, knotsU, knotsV);
        if (knotsU.Degree < 2 || knotsV.Degree < 2)
        {
            throw new GeometryException(
                GeometryError.BadKnots,
                $"a smoothed surface of degrees {knotsU.Degree} and {knotsV.Degree}; both must be at least 2, or there is no bending to "
                    + $"weigh");
        }

        if (!(lengthU > 0 && lengthV > 0 && double.IsFinite(lengthU) && double.IsFinite(lengthV)))
        {
            throw new GeometryException(GeometryError.CoincidentPoints, "a surface whose length along u or v is not a positive number");
        }

        var stride = knotsV.PoleCount;
        var fit = new PenalizedFit(knotsU.PoleCount * stride, (knotsU.Degree * stride) + knotsV.Degree);
        var product = new TensorBasis(knotsU, knotsV);
        for (var k = 0; k < points.Length; k++)
        {
            product.MoveTo(us[k], vs[k], 0);
            fit.AddPoint(product.Poles(), product.Of(0, 0), points[k]);
        }

        var (scaleU, scaleV) = (lengthU / (knotsU.End - knotsU.Start), lengthV / (knotsV.End - knotsV.Start));
        foreach (var (u, weightU) in GaussPoints.Of(knotsU))
        {
            foreach (var (v, weightV) in GaussPoints.Of(knotsV))
            {
                product.MoveTo(u, v, 2);
                var poles = product.Poles();
                var area = weightU * weightV * scaleU * scaleV;
                fit.AddBending(poles, product.Of(2, 0), area / Elementary.Pow(scaleU, 4));
                fit.AddBending(poles, product.Of(1, 1), 2 * area / Elementary.Pow(scaleU * scaleV, 2));
                fit.AddBending(poles, product.Of(0, 2), area / Elementary.Pow(scaleV, 4));
            }
        }

        var solution = fit.Solve(weight);
        return new(new(knotsU, knotsV, solution.Poles), solution.Weight, solution.EffectiveParameters);
    }
}

/// <summary>A surface that balances points against the bending energy of a thin plate.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="Weight">Factor of the energy relative to the sum of squared distances, in mm^2.</param>
/// <param name="EffectiveParameters">Effective number of poles per coordinate: trace of the matrix from points to fitted points.</param>
public sealed record SmoothedSurface(SplineSurface Surface, double Weight, double EffectiveParameters);
