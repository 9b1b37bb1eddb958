namespace ErrorMatching.Geometry;

/// <summary>The factor L of a symmetric positive definite matrix A = L L' (Golub and Van Loan, Matrix Computations, 4th edition, section
/// 4.2). Numbers have no unit of their own.</summary>
/// <remarks>Every number is reduced by the products of the columns before it, one after the other, so that every processor gives the same
/// digits. Matrices of this kind here are small and full: covariances of points. Those with a band have factors of their own, because
/// they skip what is zero and sum in another order.</remarks>
public sealed class Cholesky
{
    private readonly double[] _rows;
    private readonly int _count;

    private Cholesky(double[] rows, int count) => (_rows, _count) = (rows, count);

    /// <summary>Factors a matrix in place; null if it is not positive definite to rounding.</summary>
    /// <param name="matrix">The matrix row by row; its lower half and its diagonal become the factor, the rest is not looked at.</param>
    /// <param name="count">Number of rows.</param>
    /// <exception cref="ArgumentException">The matrix does not have that many rows and columns.</exception>
    public static Cholesky? Factor(double[] matrix, int count)
    {
        ArgumentNullException.ThrowIfNull(matrix);
        if (matrix.Length != (long)count * count)
        {
            throw new ArgumentException("The matrix is not square.", nameof(matrix));
        }

        // By columns of the factor: the sums of a row do not wait for each other.
        var column = new double[count];
        for (var k = 0; k < count; k++)
        {
            var pivot = matrix[(k * count) + k];
            if (!(pivot > 0))
            {
                return null;
            }

            pivot = matrix[(k * count) + k] = Math.Sqrt(pivot);
            for (var i = k + 1; i < count; i++)
            {
                var row = matrix.AsSpan((i * count) + k, i - k + 1);
                var factor = column[i] = row[0] /= pivot;
                row = row[1..];
                var above = column.AsSpan(k + 1, row.Length);
                for (var j = 0; j < row.Length; j++)
                {
                    row[j] -= factor * above[j];
                }
            }
        }

        return new(matrix, count);
    }

    /// <summary>A number on the diagonal of the factor, above zero. The determinant of A is the product of their squares.</summary>
    /// <param name="row">Its row, from 0.</param>
    public double Pivot(int row) => _rows[(row * _count) + row];

    /// <summary>Replaces b by the solution y of L y = b. The square of its length is b' A^-1 b.</summary>
    /// <param name="b">As many numbers as rows.</param>
    public void Forward(Span<double> b)
    {
        for (var i = 0; i < _count; i++)
        {
            var row = _rows.AsSpan(i * _count, i + 1);
            var sum = b[i];
            for (var k = 0; k < i; k++)
            {
                sum -= row[k] * b[k];
            }

            b[i] = sum / row[i];
        }
    }

    /// <summary>Replaces b by the solution x of A x = b.</summary>
    /// <param name="b">As many numbers as rows.</param>
    public void Solve(Span<double> b)
    {
        // The nearest unknown first, unlike Forward: what earlier versions wrote keeps its last digits.
        for (var i = 0; i < _count; i++)
        {
            var row = _rows.AsSpan(i * _count, i + 1);
            var sum = b[i];
            for (var k = i - 1; k >= 0; k--)
            {
                sum -= row[k] * b[k];
            }

            b[i] = sum / row[i];
        }

        for (var i = _count - 1; i >= 0; i--)
        {
            var sum = b[i];
            for (var k = i + 1; k < _count; k++)
            {
                sum -= _rows[(k * _count) + i] * b[k];
            }

            b[i] = sum / Pivot(i);
        }
    }

    /// <summary>b' A^-1 b.</summary>
    /// <param name="b">As many numbers as rows.</param>
    public double Form(ReadOnlySpan<double> b)
    {
        var solved = b.ToArray();
        Solve(solved);
        var sum = 0.0;
        for (var i = 0; i < solved.Length; i++)
        {
            sum += b[i] * solved[i];
        }

        return sum;
    }
}
