namespace ErrorMatching.Freeform;

/// <summary>The factor L of a symmetric positive definite band matrix A = L L' (Golub and Van Loan, Matrix Computations, 4th edition,
/// section 4.3.5).</summary>
internal sealed class Cholesky
{
    private readonly double[][] _rows;
    private readonly int _width;

    private Cholesky(double[][] rows, int width) => (_rows, _width) = (rows, width);

    public double LogDeterminant
    {
        get
        {
            var sum = 0.0;
            foreach (var row in _rows)
            {
                sum += 2 * Math.Log(row[^1]);
            }

            return sum;
        }
    }

    /// <summary>Factors a matrix in place; null if it is not positive definite.</summary>
    /// <param name="rows">Row i contains the columns max(0, i - width) to i.</param>
    /// <param name="width">Bandwidth left of the diagonal.</param>
    public static Cholesky? Factor(double[][] rows, int width)
    {
        for (var i = 0; i < rows.Length; i++)
        {
            var row = rows[i];
            var first = Math.Max(0, i - width);
            for (var j = first; j <= i; j++)
            {
                var other = rows[j];
                var start = Math.Max(first, j - width);
                var a = row.AsSpan(start - first, j - start);
                var b = other.AsSpan(start - Math.Max(0, j - width), j - start);
                var value = row[j - first] - Vectors.Dot(a, b);
                if (j < i)
                {
                    row[j - first] = value / other[^1];
                }
                else if (value > 0 && double.IsFinite(value))
                {
                    row[j - first] = Math.Sqrt(value);
                }
                else
                {
                    return null;
                }
            }
        }

        return new(rows, width);
    }

    /// <summary>The solution x of A x = b.</summary>
    public double[] Solve(double[] b)
    {
        var x = Forward(b);
        for (var i = x.Length - 1; i >= 0; i--)
        {
            var row = _rows[i];
            x[i] /= row[^1];
            var first = Math.Max(0, i - _width);
            for (var j = first; j < i; j++)
            {
                x[j] -= row[j - first] * x[i];
            }
        }

        return x;
    }

    /// <summary>The solution y of L y = b. Its squared length is b' A^-1 b.</summary>
    public double[] Forward(double[] b)
    {
        var y = b.AsSpan().ToArray();
        for (var i = 0; i < y.Length; i++)
        {
            var row = _rows[i];
            var first = Math.Max(0, i - _width);
            y[i] = (y[i] - Vectors.Dot(row.AsSpan(0, i - first), y.AsSpan(first, i - first))) / row[^1];
        }

        return y;
    }
}
