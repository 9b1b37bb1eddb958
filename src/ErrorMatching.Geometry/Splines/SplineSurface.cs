using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>A tensor-product B-spline surface in space, rational if it has weights. Lengths in millimeters.</summary>
/// <remarks>Pole (i, j) has the index i * CountV + j. Parameters outside the knots continue the outermost pieces.</remarks>
public sealed partial class SplineSurface
{
    private readonly Point3[] _poles;
    private readonly double[]? _weights;

    // The poles as (wx, wy, wz, w), which evaluation sums in one step each.
    private readonly Vector256<double>[] _homogeneous;

    /// <summary>Creates a surface.</summary>
    /// <param name="knotsU">Degree and knots along u.</param>
    /// <param name="knotsV">Degree and knots along v.</param>
    /// <param name="poles">Finite points, in the number that the knots require, v varying fastest.</param>
    /// <param name="weights">One positive number per pole; empty for a nonrational surface.</param>
    /// <exception cref="GeometryException">The counts do not match, a number is not finite, or a weight is not positive.</exception>
    public SplineSurface(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights = default)
    {
        ArgumentNullException.ThrowIfNull(knotsU);
        ArgumentNullException.ThrowIfNull(knotsV);
        SplinePoles.Check(knotsU.PoleCount * knotsV.PoleCount, poles, weights);
        (KnotsU, KnotsV) = (knotsU, knotsV);
        _poles = poles.ToArray();
        _weights = SplinePoles.Weights(weights);
        _homogeneous = new Vector256<double>[_poles.Length];
        for (var i = 0; i < _poles.Length; i++)
        {
            var (pole, w) = (_poles[i], _weights?[i] ?? 1);
            _homogeneous[i] = Vector256.Create(pole.X * w, pole.Y * w, pole.Z * w, w);
        }
    }

    /// <summary>Degree and knots along u.</summary>
    public KnotVector KnotsU { get; }

    /// <summary>Degree and knots along v.</summary>
    public KnotVector KnotsV { get; }

    /// <summary>Number of poles along u.</summary>
    public int CountU => KnotsU.PoleCount;

    /// <summary>Number of poles along v.</summary>
    public int CountV => KnotsV.PoleCount;

    /// <summary>The poles, v varying fastest.</summary>
    public ReadOnlySpan<Point3> Poles => _poles;

    /// <summary>One weight per pole, v varying fastest; empty if the surface is not rational.</summary>
    public ReadOnlySpan<double> Weights => _weights;

    /// <summary>True if the poles have different weights.</summary>
    public bool IsRational => _weights is not null;

    /// <summary>The point at a pair of parameters.</summary>
    public Point3 PointAt(double u, double v)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        var (spanU, spanV) = (KnotsU.SpanAt(u), KnotsV.SpanAt(v));
        Span<double> basisU = stackalloc double[p + 1];
        Span<double> basisV = stackalloc double[q + 1];
        KnotsU.Basis0(spanU, u, basisU);
        KnotsV.Basis0(spanV, v, basisV);
        var sum = Vector256<double>.Zero;
        for (var i = 0; i <= p; i++)
        {
            var row = Vector256<double>.Zero;
            var poles = _homogeneous.AsSpan(((spanU - p + i) * CountV) + spanV - q, q + 1);
            for (var j = 0; j < poles.Length; j++)
            {
                row += poles[j] * basisV[j];
            }

            sum += row * basisU[i];
        }

        return _weights is null ? new(sum[0], sum[1], sum[2]) : new(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]);
    }

    /// <summary>The point at a pair of parameters, with first and second derivatives.</summary>
    public SurfacePoint At(double u, double v)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        var (spanU, spanV) = (KnotsU.SpanAt(u), KnotsV.SpanAt(v));
        Span<double> basisU = stackalloc double[3 * (p + 1)];
        Span<double> basisV = stackalloc double[3 * (q + 1)];
        KnotsU.Basis2(spanU, u, basisU);
        KnotsV.Basis2(spanV, v, basisV);
        var (s, su, sv) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
        var (suu, suv, svv) = (s, s, s);
        for (var i = 0; i <= p; i++)
        {
            var (row, rowV, rowVV) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
            var poles = _homogeneous.AsSpan(((spanU - p + i) * CountV) + spanV - q, q + 1);
            for (var j = 0; j < poles.Length; j++)
            {
                row += poles[j] * basisV[j];
                rowV += poles[j] * basisV[q + 1 + j];
                rowVV += poles[j] * basisV[(2 * (q + 1)) + j];
            }

            var (n, d, dd) = (basisU[i], basisU[p + 1 + i], basisU[(2 * (p + 1)) + i]);
            s += row * n;
            sv += rowV * n;
            svv += rowVV * n;
            su += row * d;
            suv += rowV * d;
            suu += row * dd;
        }

        if (_weights is not null)
        {
            // Converts the weighted surface to the surface (The NURBS Book, equation 4.20).
            var (w, wu, wv, wuu, wuv, wvv) = (1 / s[3], su[3], sv[3], suu[3], suv[3], svv[3]);
            s *= w;
            su = (su - (s * wu)) * w;
            sv = (sv - (s * wv)) * w;
            suu = (suu - (su * (2 * wu)) - (s * wuu)) * w;
            suv = (suv - (su * wv) - (sv * wu) - (s * wuv)) * w;
            svv = (svv - (sv * (2 * wv)) - (s * wvv)) * w;
        }

        return new(u, v, new(s[0], s[1], s[2]), Space(su), Space(sv), Space(suu), Space(suv), Space(svv));
    }

    /// <summary>Position and derivatives at a pair of parameters.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="order">Highest order in each direction.</param>
    /// <param name="result">(order + 1)^2 vectors. Index a * (order + 1) + b receives the derivative of order a in u and b in v if a + b
    /// does not exceed the order. Index 0 is the position as a vector from the origin.</param>
    public void Derivatives(double u, double v, int order, Span<Vector3> result)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        var (spanU, spanV) = (KnotsU.SpanAt(u), KnotsV.SpanAt(v));
        var rows = order + 1;
        Span<double> basisU = stackalloc double[rows * (p + 1)];
        Span<double> basisV = stackalloc double[rows * (q + 1)];
        KnotsU.Basis(spanU, u, order, basisU);
        KnotsV.Basis(spanV, v, order, basisV);
        Span<double> w = stackalloc double[rows * rows];
        result[..(rows * rows)].Clear();
        for (var i = 0; i <= p; i++)
        {
            var first = ((spanU - p + i) * CountV) + spanV - q;
            for (var b = 0; b <= order; b++)
            {
                var (x, y, z, h) = (0.0, 0.0, 0.0, 0.0);
                for (var j = 0; j <= q; j++)
                {
                    var factor = basisV[(b * (q + 1)) + j] * (_weights is null ? 1 : _weights[first + j]);
                    ref readonly var pole = ref _poles[first + j];
                    x += pole.X * factor;
                    y += pole.Y * factor;
                    z += pole.Z * factor;
                    h += factor;
                }

                for (var a = 0; a + b <= order; a++)
                {
                    var factor = basisU[(a * (p + 1)) + i];
                    result[(a * rows) + b] += new Vector3(x * factor, y * factor, z * factor);
                    w[(a * rows) + b] += h * factor;
                }
            }
        }

        if (_weights is not null)
        {
            Project(w, order, result);
        }
    }

    /// <summary>Converts derivatives of the weighted surface to those of the surface (The NURBS Book, equation 4.20).</summary>
    private static void Project(ReadOnlySpan<double> w, int order, Span<Vector3> result)
    {
        var rows = order + 1;
        for (var k = 0; k <= order; k++)
        {
            for (var l = 0; l + k <= order; l++)
            {
                var value = result[(k * rows) + l];
                for (var i = 0; i <= k; i++)
                {
                    for (var j = 0; j <= l; j++)
                    {
                        if (i + j > 0)
                        {
                            value -= result[((k - i) * rows) + l - j] * (Binomial(k, i) * Binomial(l, j) * w[(i * rows) + j]);
                        }
                    }
                }

                result[(k * rows) + l] = value * (1 / w[0]);
            }
        }
    }

    private static Vector3 Space(Vector256<double> v) => new(v[0], v[1], v[2]);

    private static double Binomial(int n, int k)
    {
        var result = 1.0;
        for (var i = 1; i <= k; i++)
        {
            result = result * (n - i + 1) / i;
        }

        return result;
    }
}
