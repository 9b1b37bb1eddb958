namespace ErrorMatching.Geometry;

/// <summary>A B-spline curve in space, rational if it has weights. Lengths in millimeters.</summary>
/// <remarks>Multiplying all weights by one number does not change the curve. Parameters outside the knots continue the first and the last
/// piece.</remarks>
public sealed class SplineCurve
{
    private readonly Point3[] _poles;
    private readonly double[]? _weights;

    /// <summary>Creates a curve.</summary>
    /// <param name="knots">Degree and knots.</param>
    /// <param name="poles">Finite points, in the number that the knots require.</param>
    /// <param name="weights">One positive number per pole; empty for a nonrational curve.</param>
    /// <exception cref="GeometryException">The counts do not match, a number is not finite, or a weight is not positive.</exception>
    public SplineCurve(KnotVector knots, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights = default)
    {
        ArgumentNullException.ThrowIfNull(knots);
        SplinePoles.Check(knots.PoleCount, poles, weights);
        Knots = knots;
        _poles = poles.ToArray();
        _weights = SplinePoles.Weights(weights);
    }

    /// <summary>Degree and knots.</summary>
    public KnotVector Knots { get; }

    /// <summary>The poles in order.</summary>
    public ReadOnlySpan<Point3> Poles => _poles;

    /// <summary>One weight per pole; empty if the curve is not rational.</summary>
    public ReadOnlySpan<double> Weights => _weights;

    /// <summary>True if the poles have different weights.</summary>
    public bool IsRational => _weights is not null;

    /// <summary>The point at a parameter.</summary>
    public Point3 PointAt(double t)
    {
        Span<Vector3> value = stackalloc Vector3[1];
        Derivatives(t, value);
        return new(value[0].X, value[0].Y, value[0].Z);
    }

    /// <summary>The curve's position and derivatives at a parameter.</summary>
    /// <param name="t">The parameter.</param>
    /// <param name="result">Receives the position as a vector from the origin, then the first, second, ... derivative with respect to the
    /// parameter. Its length determines their number.</param>
    public void Derivatives(double t, Span<Vector3> result)
    {
        var order = result.Length - 1;
        var p = Knots.Degree;
        var span = Knots.SpanAt(t);
        Span<double> basis = stackalloc double[(order + 1) * (p + 1)];
        Knots.Basis.WithDerivatives(span, t, order, basis);
        Span<double> w = stackalloc double[order + 1];
        for (var k = 0; k <= order; k++)
        {
            var sum = Vector3.Zero;
            for (var j = 0; j <= p; j++)
            {
                var pole = span - p + j;
                var factor = basis[(k * (p + 1)) + j] * (_weights?[pole] ?? 1);
                sum += new Vector3(_poles[pole].X, _poles[pole].Y, _poles[pole].Z) * factor;
                w[k] += factor;
            }

            result[k] = sum;
        }

        if (_weights is not null)
        {
            Project(w, result);
        }
    }

    /// <summary>Converts derivatives of the weighted curve to those of the curve (The NURBS Book, equation 4.8).</summary>
    private static void Project(ReadOnlySpan<double> w, Span<Vector3> result)
    {
        for (var k = 0; k < result.Length; k++)
        {
            var value = result[k];
            var binomial = 1.0;
            for (var i = 1; i <= k; i++)
            {
                binomial = binomial * (k - i + 1) / i;
                value -= result[k - i] * (binomial * w[i]);
            }

            result[k] = value * (1 / w[0]);
        }
    }

    // Other representations of the same curve: other knots, a higher degree, a part, reversed.

    /// <summary>Converts curves to <see cref="KnotVector.Common"/> knots: one degree and the same knots for all, as needed for skinning.
    /// The curves do not move.</summary>
    /// <remarks>Other ranges are mapped to the range of the first curve. Knots that differ by rounding only
    /// (<see cref="KnotVector.SameKnot"/>) are merged, which moves a curve by at most that share of its length.</remarks>
    /// <param name="curves">At least one.</param>
    /// <exception cref="GeometryException">The list is empty.</exception>
    public static IReadOnlyList<SplineCurve> Compatible(IReadOnlyList<SplineCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(curves);
        var common = KnotVector.Common([.. curves.Select(c => c.Knots)]);
        return [.. curves.Select(c => From(c.Rows().Snap(common).ElevateTo(common.Degree).Onto(common), c.IsRational))];
    }

    /// <summary>The same curve over knots that contain its own (knot insertion, Oslo algorithm).</summary>
    /// <param name="finer">Clamped knots of the same degree over the same range, or over a part of it, which gives that part.</param>
    /// <exception cref="GeometryException">The knots do not contain the curve's.</exception>
    public SplineCurve WithKnots(KnotVector finer)
    {
        ArgumentNullException.ThrowIfNull(finer);
        return From(Rows().Onto(finer), IsRational);
    }

    /// <summary>The same curve, clamped, with an additional knot.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineCurve InsertKnot(double t, int times = 1) => WithKnots(Knots.Insert(t, times));

    /// <summary>The same curve, clamped, with a higher degree.</summary>
    /// <param name="degree">From the curve's degree to <see cref="KnotVector.MaxDegree"/>.</param>
    /// <exception cref="GeometryException">The degree is out of range.</exception>
    public SplineCurve ElevateTo(int degree) => From(Rows().ElevateTo(degree), IsRational);

    /// <summary>The part of the curve between two parameters.</summary>
    /// <param name="from">First parameter.</param>
    /// <param name="to">Last parameter.</param>
    /// <exception cref="GeometryException">The part is empty or exceeds the curve.</exception>
    public SplineCurve Between(double from, double to) => WithKnots(Knots.Between(from, to));

    /// <summary>The curve before and after a parameter.</summary>
    /// <param name="t">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineCurve Before, SplineCurve After) Split(double t) => (Between(Knots.Start, t), Between(t, Knots.End));

    /// <summary>The same curve, starting and ending at its first and last pole.</summary>
    public SplineCurve Clamp() => WithKnots(Knots.Clamp());

    /// <summary>The reversed curve, over the same parameter range.</summary>
    public SplineCurve Reverse() => From(Rows().Reverse(), IsRational);

    /// <summary>The same curve over another parameter range.</summary>
    /// <param name="start">New first parameter.</param>
    /// <param name="end">New last parameter, larger than the first.</param>
    /// <exception cref="GeometryException">The range is empty.</exception>
    public SplineCurve Reparametrize(double start, double end) => new(Knots.Affine(start, end), _poles, _weights);

    /// <summary>The polynomial pieces in order, each a Bezier curve over its part of the parameters.</summary>
    public IReadOnlyList<SplineCurve> Pieces()
    {
        var breaks = Knots.Breaks;
        var rows = Rows();
        return [.. breaks.Skip(1).Select((to, i) => From(rows.Onto(Knots.Between(breaks[i], to)), IsRational))];
    }

    /// <summary>A box that contains the curve: that of its poles.</summary>
    public Box3 Box() => Box3.Around(Clamp()._poles);

    internal static SplineCurve From(SplineRows rows, bool rational)
    {
        var (poles, weights) = SplinePoles.Unflatten(rows.Values, rational);
        return new(rows.Knots, poles, weights);
    }

    internal SplineRows Rows() => new(Knots, SplinePoles.Flatten(_poles, _weights), IsRational ? 4 : 3);

    // Knot removal.

    /// <summary>Removes a knot once from the clamped curve, moving it as little as possible. The ends do not move.</summary>
    /// <param name="t">An inner knot.</param>
    /// <returns>The curve, and a bound in millimeters of its displacement at the same parameter: the largest distance between the poles
    /// over the old knots. For a redundant knot, this is only rounding.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a weight of the new curve would not be
    /// positive.</exception>
    public (SplineCurve Curve, double MovedMm) RemoveKnot(double t)
    {
        var rows = Rows().Onto(Knots.Clamp());
        var less = rows.Remove(t);
        return (From(less, IsRational), SplinePoles.Moved(rows.Values, less.Onto(rows.Knots).Values, IsRational));
    }

    // The closest point.

    private SplineSurface? _asSurface;

    /// <summary>The point of the curve closest to a given point, with the same global search and accuracy as
    /// <see cref="SplineSurface.ClosestPoint(Point3, double)"/>.</summary>
    /// <param name="p">The point.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double tolerance = 1e-7) => Foot(AsSurface().ClosestPoint(p, tolerance));

    /// <summary>The point of the curve closest to a given point, starting from a place that is probably near it. The result is as global
    /// and accurate as without it.</summary>
    /// <param name="p">The point.</param>
    /// <param name="near">Parameter at which the search starts.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point or the parameter is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double near, double tolerance) => Foot(AsSurface().ClosestPoint(p, near, 0.5, tolerance));

    private static CurveFoot Foot(SurfaceFoot foot) => new(foot.At.U, foot.At.Position, foot.Offset, foot.Accuracy);

    /// <summary>The curve as a surface that is constant along v, so that the same search can be used.</summary>
    private SplineSurface AsSurface()
    {
        if (_asSurface is null)
        {
            var (poles, weights) = (new Point3[2 * _poles.Length], new double[IsRational ? 2 * _poles.Length : 0]);
            for (var i = 0; i < poles.Length; i++)
            {
                poles[i] = _poles[i / 2];
            }

            for (var i = 0; i < weights.Length; i++)
            {
                weights[i] = _weights![i / 2];
            }

            _asSurface = new(Knots, KnotVector.Clamped(1, [0, 1]), poles, weights);
        }

        return _asSurface;
    }
}

/// <summary>The point of a curve closest to a given point. Lengths in millimeters.</summary>
/// <param name="T">Its parameter.</param>
/// <param name="Position">Its position.</param>
/// <param name="Offset">The displacement from it to the given point.</param>
/// <param name="Accuracy">Proven bound: no point of the curve is closer by more than this.</param>
public readonly record struct CurveFoot(double T, Point3 Position, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the given point from the curve.</summary>
    public double Distance => Offset.Length;
}
