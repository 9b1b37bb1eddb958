using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The factor L of a symmetric positive definite band matrix A = L L' (Golub and Van Loan, Matrix Computations, 4th edition,
/// section 4.3.5).</summary>
/// <remarks>The search for a field factors matrices of hundreds of rows again and again. So it sums four numbers at a time
/// (<see cref="Vectors"/>), which gives other last digits than the sums of Geometry's <see cref="Cholesky"/>.</remarks>
internal sealed class BandedCholesky
{
    private readonly double[][] _rows;
    private readonly int _width;

    private BandedCholesky(double[][] rows, int width) => (_rows, _width) = (rows, width);

    public double LogDeterminant
    {
        get
        {
            var sum = 0.0;
            foreach (var row in _rows)
            {
                sum += 2 * Elementary.Log(row[^1]);
            }

            return sum;
        }
    }

    /// <summary>Factors a matrix in place; null if it is not positive definite.</summary>
    /// <param name="rows">Row i contains the columns max(0, i - width) to i.</param>
    /// <param name="width">Bandwidth left of the diagonal.</param>
    public static BandedCholesky? Factor(double[][] rows, int width)
    {
        for (var i = 0; i < rows.Length; i++)
        {
            var row = rows[i];
            var first = Math.Max(0, i - width);
            var j = first;
            for (; j + Vectors.Width <= i; j += Vectors.Width)
            {
                Vectors.Substitute(row.AsSpan(0, j - first + Vectors.Width), Part(j), Part(j + 1), Part(j + 2), Part(j + 3));
            }

            for (; j < i; j++)
            {
                var other = Part(j);
                row[j - first] = (row[j - first] - Vectors.Dot(row.AsSpan(0, j - first), other)) / other[^1];
            }

            var value = row[^1] - Vectors.Dot(row.AsSpan(0, i - first), row);
            if (!(value > 0 && double.IsFinite(value)))
            {
                return null;
            }

            row[^1] = Math.Sqrt(value);

            // Row k from the first column of row i on.
            ReadOnlySpan<double> Part(int k) => rows[k].AsSpan(first - Math.Max(0, k - width));
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
