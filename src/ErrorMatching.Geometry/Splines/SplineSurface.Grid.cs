namespace ErrorMatching.Geometry;

/// <content>Evaluation at many places.</content>
public sealed partial class SplineSurface
{
    /// <summary>The points at every pair of parameters of two lists, v varying fastest. Evaluating along u for all poles, then along v, is
    /// faster than separately.</summary>
    /// <param name="us">Parameters along u in any order.</param>
    /// <param name="vs">Parameters along v in any order.</param>
    public Point3[] PointsAt(ReadOnlySpan<double> us, ReadOnlySpan<double> vs)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        var basisV = new double[vs.Length * (q + 1)];
        var firstV = new int[vs.Length];
        for (var j = 0; j < vs.Length; j++)
        {
            firstV[j] = KnotsV.SpanAt(vs[j]) - q;
            KnotsV.Basis(firstV[j] + q, vs[j], 0, basisV.AsSpan(j * (q + 1), q + 1));
        }

        var result = new Point3[us.Length * vs.Length];
        var basisU = new double[p + 1];
        var line = new double[4 * CountV];
        for (var i = 0; i < us.Length; i++)
        {
            var span = KnotsU.SpanAt(us[i]);
            KnotsU.Basis(span, us[i], 0, basisU);
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

    /// <summary>The weighted poles, and weights, of the curve along v at a parameter u.</summary>
    private void AlongU(int first, double[] basis, double[] line)
    {
        Array.Clear(line);
        for (var i = 0; i < basis.Length; i++)
        {
            for (var j = 0; j < CountV; j++)
            {
                var number = ((first + i) * CountV) + j;
                var factor = basis[i] * (_weights?[number] ?? 1);
                ref readonly var pole = ref _poles[number];
                line[4 * j] += factor * pole.X;
                line[(4 * j) + 1] += factor * pole.Y;
                line[(4 * j) + 2] += factor * pole.Z;
                line[(4 * j) + 3] += factor;
            }
        }
    }
}
