namespace ErrorMatching.Freeform;

/// <summary>The normal equations of a smoothed bicubic spline on two axes. Not thread-safe.</summary>
/// <param name="U">The first axis.</param>
/// <param name="V">The second axis.</param>
internal sealed record SplineEquations(SplineAxis U, SplineAxis V)
{
    private readonly double[][] _bending = BendingOf(U, V);

    // The same values are fitted with every weight.
    private readonly Dictionary<FieldData, (double[][] Rows, double[] Right)> _known = new(ReferenceEqualityComparer.Instance);

    /// <summary>Bandwidth of the equations left of the diagonal.</summary>
    public int Width => WidthOf(V);

    /// <summary>The equations for values with a weight of the bending energy. Row i has columns i - width to i.</summary>
    public (double[][] Rows, double[] Right) Of(FieldData data, double weight)
    {
        if (!_known.TryGetValue(data, out var known))
        {
            _known[data] = known = Squares(data);
        }

        var rows = new double[_bending.Length][];
        for (var i = 0; i < rows.Length; i++)
        {
            rows[i] = (double[])known.Rows[i].Clone();
            Vectors.Subtract(rows[i], -weight * data.Count, _bending[i]);
        }

        return (rows, known.Right);
    }

    private static int WidthOf(SplineAxis v) => (3 * v.Count) + 3;

    private static double[][] Empty(SplineAxis u, SplineAxis v)
    {
        var rows = new double[u.Count * v.Count][];
        for (var row = 0; row < rows.Length; row++)
        {
            rows[row] = new double[Math.Min(row, WidthOf(v)) + 1];
        }

        return rows;
    }

    private (double[][] Rows, double[] Right) Squares(FieldData data)
    {
        var (rows, width) = (Empty(U, V), Width);
        var right = new double[rows.Length];
        for (var k = 0; k < data.Count; k++)
        {
            var (a, b) = (U.At(data.U[k]), V.At(data.V[k]));
            for (var i = 0; i < 16; i++)
            {
                var row = ((a.First + (i / 4)) * V.Count) + b.First + (i % 4);
                var factor = a.Values[i / 4] * b.Values[i % 4];
                right[row] += factor * data.Z[k];
                for (var p = 0; p <= i / 4; p++)
                {
                    var to = rows[row].AsSpan(((a.First + p) * V.Count) + b.First - Math.Max(0, row - width));
                    var share = factor * a.Values[p];
                    var last = p < i / 4 ? 3 : i % 4;
                    for (var q = 0; q <= last; q++)
                    {
                        to[q] += share * b.Values[q];
                    }
                }
            }
        }

        return (rows, right);
    }

    /// <summary>The integral of f_uu^2 + 2 f_uv^2 + f_vv^2 as a quadratic form of the poles.</summary>
    private static double[][] BendingOf(SplineAxis u, SplineAxis v)
    {
        var (u0, u1, u2) = (u.Products(0), u.Products(1), u.Products(2));
        var (v0, v1, v2) = (v.Products(0), v.Products(1), v.Products(2));
        var (rows, width) = (Empty(u, v), WidthOf(v));
        for (var row = 0; row < rows.Length; row++)
        {
            var (i, j) = (row / v.Count, row % v.Count);
            for (var k = Math.Max(0, i - 3); k <= i; k++)
            {
                for (var l = Math.Max(0, j - 3); l <= Math.Min(v.Count - 1, j + 3); l++)
                {
                    var column = (k * v.Count) + l;
                    if (column <= row)
                    {
                        // A trace of the values themselves keeps planes determined where lines are missing.
                        rows[row][column - Math.Max(0, row - width)] = (u2[i][k] * v0[j][l]) + (2 * u1[i][k] * v1[j][l])
                            + (u0[i][k] * v2[j][l]) + (1e-9 * u0[i][k] * v0[j][l]);
                    }
                }
            }
        }

        return rows;
    }
}
