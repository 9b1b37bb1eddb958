using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>The poles of a tensor-product B-spline surface, and what they evaluate to.</summary>
/// <remarks>Pole (i, j) has the index i * count along v + j.</remarks>
internal sealed class SurfacePoles
{
    private readonly KnotVector _knotsU;
    private readonly KnotVector _knotsV;
    private readonly int _countV;
    private readonly Point3[] _poles;
    private readonly double[]? _weights;

    // The poles as (wx, wy, wz, w), which evaluation sums in one step each.
    private readonly Vector256<double>[] _homogeneous;

    /// <summary>Creates the poles of a surface.</summary>
    /// <exception cref="GeometryException">The counts do not match, a number is not finite, or a weight is not positive.</exception>
    public SurfacePoles(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights)
    {
        SplinePoles.Check(knotsU.PoleCount * knotsV.PoleCount, poles, weights);
        (_knotsU, _knotsV, _countV) = (knotsU, knotsV, knotsV.PoleCount);
        _poles = poles.ToArray();
        _weights = SplinePoles.Weights(weights);
        _homogeneous = new Vector256<double>[_poles.Length];
        for (var i = 0; i < _poles.Length; i++)
        {
            var (pole, w) = (_poles[i], _weights?[i] ?? 1);
            _homogeneous[i] = Vector256.Create(pole.X * w, pole.Y * w, pole.Z * w, w);
        }
    }

    /// <summary>The poles, v varying fastest.</summary>
    public ReadOnlySpan<Point3> Points => _poles;

    /// <summary>One weight per pole; empty if the surface is not rational.</summary>
    public ReadOnlySpan<double> Weights => _weights;

    /// <summary>True if the poles have different weights.</summary>
    public bool IsRational => _weights is not null;

    /// <summary>The poles as rows of numbers, homogeneous if rational.</summary>
    public SurfaceRows Rows() => new(_knotsU, _knotsV, SplinePoles.Flatten(_poles, _weights), IsRational ? 4 : 3);

    /// <inheritdoc cref="SplineSurface.PointAt"/>
    public Point3 PointAt(double u, double v)
    {
        var (p, q) = (_knotsU.Degree, _knotsV.Degree);
        var (spanU, spanV) = (_knotsU.SpanAt(u), _knotsV.SpanAt(v));
        Span<double> basisU = stackalloc double[p + 1];
        Span<double> basisV = stackalloc double[q + 1];
        _knotsU.Basis.Values(spanU, u, basisU);
        _knotsV.Basis.Values(spanV, v, basisV);
        var sum = Vector256<double>.Zero;
        for (var i = 0; i <= p; i++)
        {
            var row = Vector256<double>.Zero;
            var poles = _homogeneous.AsSpan(((spanU - p + i) * _countV) + spanV - q, q + 1);
            for (var j = 0; j < poles.Length; j++)
            {
                row += poles[j] * basisV[j];
            }

            sum += row * basisU[i];
        }

        return _weights is null ? new(sum[0], sum[1], sum[2]) : new(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]);
    }

    /// <inheritdoc cref="SplineSurface.At"/>
    public SurfacePoint At(double u, double v)
    {
        var (p, q) = (_knotsU.Degree, _knotsV.Degree);
        var (spanU, spanV) = (_knotsU.SpanAt(u), _knotsV.SpanAt(v));
        Span<double> basisU = stackalloc double[3 * (p + 1)];
        Span<double> basisV = stackalloc double[3 * (q + 1)];
        _knotsU.Basis.WithTwoDerivatives(spanU, u, basisU);
        _knotsV.Basis.WithTwoDerivatives(spanV, v, basisV);
        var (s, su, sv) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
        var (suu, suv, svv) = (s, s, s);
        for (var i = 0; i <= p; i++)
        {
            var (row, rowV, rowVV) = (Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);
            var poles = _homogeneous.AsSpan(((spanU - p + i) * _countV) + spanV - q, q + 1);
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

    /// <inheritdoc cref="SplineSurface.Derivatives"/>
    public void Derivatives(double u, double v, int order, Span<Vector3> result)
    {
        var (p, q) = (_knotsU.Degree, _knotsV.Degree);
        var (spanU, spanV) = (_knotsU.SpanAt(u), _knotsV.SpanAt(v));
        var rows = order + 1;
        Span<double> basisU = stackalloc double[rows * (p + 1)];
        Span<double> basisV = stackalloc double[rows * (q + 1)];
        _knotsU.Basis.WithDerivatives(spanU, u, order, basisU);
        _knotsV.Basis.WithDerivatives(spanV, v, order, basisV);
        Span<double> w = stackalloc double[rows * rows];
        result[..(rows * rows)].Clear();
        for (var i = 0; i <= p; i++)
        {
            var first = ((spanU - p + i) * _countV) + spanV - q;
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

    /// <inheritdoc cref="SplineSurface.PointsAt"/>
    public Point3[] PointsAt(ReadOnlySpan<double> us, ReadOnlySpan<double> vs)
    {
        var (p, q) = (_knotsU.Degree, _knotsV.Degree);
        var basisV = new double[vs.Length * (q + 1)];
        var firstV = new int[vs.Length];
        for (var j = 0; j < vs.Length; j++)
        {
            firstV[j] = _knotsV.SpanAt(vs[j]) - q;
            _knotsV.Basis.WithDerivatives(firstV[j] + q, vs[j], 0, basisV.AsSpan(j * (q + 1), q + 1));
        }

        var result = new Point3[us.Length * vs.Length];
        var basisU = new double[p + 1];
        var line = new double[4 * _countV];
        for (var i = 0; i < us.Length; i++)
        {
            var span = _knotsU.SpanAt(us[i]);
            _knotsU.Basis.WithDerivatives(span, us[i], 0, basisU);
            AlongU(span - p, basisU, line);
            for (var j = 0; j < vs.Length; j++)
            {
                var (x, y, z, w) = (0.0, 0.0, 0.0, 0.0);
                for (var k = 0; k <= q; k++)
                {
                    var factor = basisV[(j * (q + 1)) + k];
                    var at = 4 * (firstV[j] + k);
                    (x, y, z, w) = (
                        x + (factor * line[at]), y + (factor * line[at + 1]), z + (factor * line[at + 2]), w + (factor * line[at + 3]));
                }

                result[(i * vs.Length) + j] = _weights is null ? new(x, y, z) : new(x / w, y / w, z / w);
            }
        }

        return result;
    }

    /// <summary>The weighted line at v over one span of u, and its derivative with respect to v, in the basis functions along u.</summary>
    /// <param name="spanU">The span.</param>
    /// <param name="v">The parameter of the line.</param>
    /// <param name="rows">One row of degree + 1 factors for each number of the result.</param>
    /// <param name="place">Receives the line.</param>
    /// <param name="slope">Receives its derivative with respect to v.</param>
    public void AlongV(int spanU, double v, ReadOnlySpan<double> rows, Span<Vector256<double>> place, Span<Vector256<double>> slope)
    {
        var (p, q) = (_knotsU.Degree, _knotsV.Degree);
        var spanV = _knotsV.SpanAt(v);
        Span<double> basis = stackalloc double[3 * (q + 1)];
        _knotsV.Basis.WithTwoDerivatives(spanV, v, basis);
        place.Clear();
        slope.Clear();
        for (var i = 0; i <= p; i++)
        {
            var (row, rowV) = (Vector256<double>.Zero, Vector256<double>.Zero);
            var poles = _homogeneous.AsSpan(((spanU - p + i) * _countV) + spanV - q, q + 1);
            for (var j = 0; j < poles.Length; j++)
            {
                row += poles[j] * basis[j];
                rowV += poles[j] * basis[q + 1 + j];
            }

            for (var k = 0; k < place.Length; k++)
            {
                var factor = rows[(k * (p + 1)) + i];
                place[k] += row * factor;
                slope[k] += rowV * factor;
            }
        }
    }

    /// <summary>The weighted poles, and weights, of the curve along v at a parameter u.</summary>
    private void AlongU(int first, double[] basis, double[] line)
    {
        Array.Clear(line);
        for (var i = 0; i < basis.Length; i++)
        {
            for (var j = 0; j < _countV; j++)
            {
                var number = ((first + i) * _countV) + j;
                var factor = basis[i] * (_weights?[number] ?? 1);
                ref readonly var pole = ref _poles[number];
                line[4 * j] += factor * pole.X;
                line[(4 * j) + 1] += factor * pole.Y;
                line[(4 * j) + 2] += factor * pole.Z;
                line[(4 * j) + 3] += factor;
            }
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
