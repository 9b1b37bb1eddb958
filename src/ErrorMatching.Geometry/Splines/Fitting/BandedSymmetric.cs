namespace ErrorMatching.Geometry;

/// <summary>A symmetric positive definite band matrix in Cholesky factors (Golub and Van Loan, Matrix Computations, 4th edition, section
/// 4.3.5).</summary>
/// <remarks>A thin plate of 400 poles has a band of 64: unlike <see cref="Cholesky"/>, it stores and visits nothing beside the band, and
/// tells the inverse inside of it.</remarks>
internal sealed class BandedSymmetric
{
    private readonly double[] _triangle;
    private readonly int _count;
    private readonly int _width;

    private BandedSymmetric(double[] triangle, int count, int width) => (_triangle, _count, _width) = (triangle, count, width);

    /// <summary>Factors a matrix; null if it is not positive definite to rounding.</summary>
    /// <param name="matrix">Row by row, <paramref name="width"/> elements, up to and including the diagonal; overwritten.</param>
    /// <param name="count">Number of rows.</param>
    /// <param name="width">Elements per row.</param>
    public static BandedSymmetric? Factor(double[] matrix, int count, int width)
    {
        for (var i = 0; i < count; i++)
        {
            var row = matrix.AsSpan(i * width, width);
            var given = row[width - 1];
            for (var j = Math.Max(0, i - width + 1); j <= i; j++)
            {
                // Both rows, starting at the first column that they share.
                var other = matrix.AsSpan(j * width, width);
                var first = Math.Max(0, i - width + 1);
                var sum = row[j - i + width - 1];
                var a = row[(first - i + width - 1)..(j - i + width - 1)];
                var b = other[(first - j + width - 1)..(width - 1)];
                sum -= Product(a, b);
                if (j < i)
                {
                    row[j - i + width - 1] = sum / other[width - 1];
                }
                else if (!(sum > 1e-15 * given))
                {
                    return null;
                }
                else
                {
                    row[width - 1] = Math.Sqrt(sum);
                }
            }
        }

        return new(matrix, count, width);
    }

    /// <summary>Solves in place for several right-hand sides, which vary fastest.</summary>
    public void Solve(Span<double> rights, int columns)
    {
        for (var i = 0; i < _count; i++)
        {
            for (var j = Math.Max(0, i - _width + 1); j < i; j++)
            {
                Subtract(rights, i, j, At(i, j), columns);
            }

            Divide(rights, i, At(i, i), columns);
        }

        for (var i = _count - 1; i >= 0; i--)
        {
            for (var k = i + 1; k < Math.Min(_count, i + _width); k++)
            {
                Subtract(rights, i, k, At(k, i), columns);
            }

            Divide(rights, i, At(i, i), columns);
        }
    }

    /// <summary>The elements of the inverse inside the band, in the layout of the matrix (K. Takahashi, J. Fagan and M. Chin, "Formation
    /// of a sparse bus impedance matrix", 1973; for splines M. F. Hutchinson and F. R. de Hoog, "Smoothing noisy data with spline
    /// functions", Numer. Math. 47, 1985).</summary>
    public double[] Inverse()
    {
        var z = new double[_triangle.Length];
        // The triangle by columns, so that sums run over contiguous elements.
        var column = new double[_width];
        var inverse = new double[_width];
        for (var j = _count - 1; j >= 0; j--)
        {
            var last = Math.Min(_count - 1, j + _width - 1);
            var length = last - j;
            var diagonal = At(j, j);
            for (var k = 1; k <= length; k++)
            {
                column[k] = At(j + k, j) / diagonal;
            }

            for (var i = last; i > j; i--)
            {
                var sum = 0.0;
                for (var k = j + 1; k <= i; k++)
                {
                    sum += column[k - j] * z[(i * _width) + k - i + _width - 1];
                }

                for (var k = i + 1; k <= last; k++)
                {
                    sum += column[k - j] * z[(k * _width) + i - k + _width - 1];
                }

                inverse[i - j] = -sum;
            }

            var own = 1 / (diagonal * diagonal);
            for (var k = 1; k <= length; k++)
            {
                own -= column[k] * inverse[k];
                z[((j + k) * _width) + _width - 1 - k] = inverse[k];
            }

            z[(j * _width) + _width - 1] = own;
        }

        return z;
    }

    private static double Product(ReadOnlySpan<double> a, ReadOnlySpan<double> b)
    {
        var sum = 0.0;
        for (var i = 0; i < a.Length; i++)
        {
            sum += a[i] * b[i];
        }

        return sum;
    }

    private static void Subtract(Span<double> rights, int row, int other, double factor, int columns)
    {
        for (var c = 0; c < columns; c++)
        {
            rights[(row * columns) + c] -= factor * rights[(other * columns) + c];
        }
    }

    private static void Divide(Span<double> rights, int row, double divisor, int columns)
    {
        for (var c = 0; c < columns; c++)
        {
            rights[(row * columns) + c] /= divisor;
        }
    }

    private double At(int row, int column) => _triangle[(row * _width) + column - row + _width - 1];
}
