using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <content>Support for <see cref="SurfaceLine"/>.</content>
public sealed partial class SplineSurface
{
    /// <summary>The weighted line at v over one span of u, and its derivative with respect to v, in the basis functions along u.</summary>
    /// <param name="spanU">The span.</param>
    /// <param name="v">The parameter of the line.</param>
    /// <param name="rows">One row of degree + 1 factors for each number of the result.</param>
    /// <param name="place">Receives the line.</param>
    /// <param name="slope">Receives its derivative with respect to v.</param>
    internal void AlongV(int spanU, double v, ReadOnlySpan<double> rows, Span<Vector256<double>> place, Span<Vector256<double>> slope)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        var spanV = KnotsV.SpanAt(v);
        Span<double> basis = stackalloc double[3 * (q + 1)];
        KnotsV.Basis2(spanV, v, basis);
        place.Clear();
        slope.Clear();
        for (var i = 0; i <= p; i++)
        {
            var (row, rowV) = (Vector256<double>.Zero, Vector256<double>.Zero);
            var poles = _homogeneous.AsSpan(((spanU - p + i) * CountV) + spanV - q, q + 1);
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
}
