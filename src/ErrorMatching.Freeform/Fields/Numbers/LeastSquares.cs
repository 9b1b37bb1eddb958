namespace ErrorMatching.Freeform;

/// <summary>Linear least squares by orthogonalization, repeated if little remains of a column (modified Gram-Schmidt with
/// reorthogonalization; Bjorck, Numerical Methods for Least Squares Problems, section 2.4.5). It avoids the normal equations.</summary>
internal sealed class LeastSquares
{
    /// <summary>A column depends on the others if less than this share of it remains.</summary>
    public const double Dependent = 1e-11;

    /// <summary>No second pass is needed if at least this share of a column remains.</summary>
    private const double Clear = 0.1;

    private readonly double[][] _r;

    private LeastSquares(double[][] r, double[] coefficients, double[] residuals)
    {
        (_r, Coefficients, Residuals) = (r, coefficients, residuals);
        SquareSum = Product(residuals, residuals);
    }

    public double[] Coefficients { get; }

    public double[] Residuals { get; }

    public double SquareSum { get; }

    /// <summary>Fits columns to values; null if a column depends on the others, or there are more columns than values.</summary>
    public static LeastSquares? Solve(IReadOnlyList<double[]> columns, double[] values)
    {
        var p = columns.Count;
        if (p > values.Length)
        {
            return null;
        }

        var q = new double[p][];
        var r = new double[p][];
        var projections = new double[p];
        var rest = (double[])values.Clone();
        for (var k = 0; k < p; k++)
        {
            q[k] = (double[])columns[k].Clone();
            r[k] = new double[k + 1];
            var before = Math.Sqrt(Product(q[k], q[k]));
            for (var pass = 0; pass < 2 && !(r[k][k] > Clear * before); pass++)
            {
                for (var j = 0; j < k; j++)
                {
                    r[k][j] += Remove(q[k], q[j]);
                }

                r[k][k] = Math.Sqrt(Product(q[k], q[k]));
            }

            if (!(r[k][k] > Dependent * before))
            {
                return null;
            }

            Scale(q[k], 1 / r[k][k]);
            projections[k] = Remove(rest, q[k]);
        }

        for (var k = 0; k < p; k++)
        {
            projections[k] += Remove(rest, q[k]);
        }

        for (var k = p - 1; k >= 0; k--)
        {
            projections[k] /= r[k][k];
            for (var j = 0; j < k; j++)
            {
                projections[j] -= r[k][j] * projections[k];
            }
        }

        return new(r, projections, rest);
    }

    /// <summary>The variance of the prediction for given column values, as a share of the variance of one value.</summary>
    public double Leverage(ReadOnlySpan<double> row)
    {
        var sum = 0.0;
        Span<double> w = stackalloc double[row.Length];
        for (var k = 0; k < row.Length; k++)
        {
            var value = row[k];
            for (var j = 0; j < k; j++)
            {
                value -= _r[k][j] * w[j];
            }

            w[k] = value / _r[k][k];
            sum += w[k] * w[k];
        }

        return sum;
    }

    /// <summary>Subtracts a vector's component along a unit vector, and returns the component.</summary>
    public static double Remove(double[] vector, double[] unit)
    {
        var part = Product(vector, unit);
        Vectors.Subtract(vector, part, unit);
        return part;
    }

    public static double Product(double[] a, double[] b) => Vectors.Dot(a, b);

    public static void Scale(double[] vector, double factor)
    {
        for (var i = 0; i < vector.Length; i++)
        {
            vector[i] *= factor;
        }
    }
}
