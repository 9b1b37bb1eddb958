namespace ErrorMatching.Geometry;

/// <summary>A B-spline curve in space, rational if it has weights. Lengths in millimeters.</summary>
/// <remarks>Multiplying all weights by one number does not change the curve. Parameters outside the knots continue the first and the last
/// piece.</remarks>
public sealed partial class SplineCurve
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
}
