namespace ErrorMatching.Freeform;

/// <summary>Eigenvalues and eigenvectors of a symmetric matrix, by Householder tridiagonalization and rotations with implicit shifts
/// (Golub and Van Loan, Matrix Computations, 4th edition, sections 8.3.1 and 8.3.3). Small eigenvalues are accurate to the rounding of the
/// largest.</summary>
internal sealed class SymmetricEigen
{
    private const int MostSweeps = 60;

    /// <summary>An off-diagonal element below this share of the largest element counts as zero. This is far below the rounding of the
    /// reflections.</summary>
    private const double Nothing = 1e-18;

    /// <summary>Decomposes a symmetric matrix and overwrites it.</summary>
    public SymmetricEigen(double[][] a)
    {
        var beside = new double[a.Length];
        var (values, vectors) = (new double[a.Length], Tridiagonal(a, beside));
        for (var i = 0; i < values.Length; i++)
        {
            values[i] = a[i][i];
        }

        Diagonalize(values, beside, vectors);
        // Sorted by insertion, so that equal ones keep their order.
        for (var i = 1; i < values.Length; i++)
        {
            for (var k = i; k > 0 && values[k - 1] < values[k]; k--)
            {
                (values[k - 1], values[k], vectors[k - 1], vectors[k]) = (values[k], values[k - 1], vectors[k], vectors[k - 1]);
            }
        }

        (Values, Vectors) = (values, vectors);
    }

    /// <summary>The eigenvalues, the largest first.</summary>
    public double[] Values { get; }

    /// <summary>Row k is the unit eigenvector of eigenvalue k.</summary>
    public double[][] Vectors { get; }

    /// <summary>Leaves the diagonal of the tridiagonal matrix in <paramref name="a"/> and returns the columns, as rows, of the orthogonal
    /// transformation.</summary>
    private static double[][] Tridiagonal(double[][] a, double[] beside)
    {
        var n = a.Length;
        var mirrors = new double[n][];
        for (var k = 0; k + 1 < n; k++)
        {
            var unit = a[k].AsSpan(k + 1).ToArray();
            var length = Math.Sqrt(LeastSquares.Product(unit, unit));
            beside[k] = -Math.CopySign(length, unit[0]);
            unit[0] -= beside[k];
            var left = Math.Sqrt(LeastSquares.Product(unit, unit));
            if (!(left > 0))
            {
                beside[k] = 0;
                mirrors[k] = [];
                continue;
            }

            LeastSquares.Scale(unit, 1 / left);
            mirrors[k] = unit;
            Reflect(a, k + 1, unit);
        }

        var columns = new double[n][];
        for (var i = 0; i < n; i++)
        {
            columns[i] = new double[n];
            columns[i][i] = 1;
        }

        for (var k = n - 2; k >= 0; k--)
        {
            for (var i = k + 1; i < n && mirrors[k].Length > 0; i++)
            {
                var row = columns[i].AsSpan(k + 1);
                ErrorMatching.Freeform.Vectors.Subtract(row, 2 * ErrorMatching.Freeform.Vectors.Dot(mirrors[k], row), mirrors[k]);
            }
        }

        return columns;
    }

    /// <summary>Applies a reflection to the lower right part of a symmetric matrix from both sides.</summary>
    private static void Reflect(double[][] a, int first, double[] unit)
    {
        var count = unit.Length;
        var image = new double[count];
        for (var i = 0; i < count; i++)
        {
            image[i] = ErrorMatching.Freeform.Vectors.Dot(unit, a[first + i].AsSpan(first));
        }

        ErrorMatching.Freeform.Vectors.Subtract(image, LeastSquares.Product(unit, image), unit);
        for (var i = 0; i < count; i++)
        {
            var row = a[first + i].AsSpan(first);
            ErrorMatching.Freeform.Vectors.Subtract(row, 2 * unit[i], image);
            ErrorMatching.Freeform.Vectors.Subtract(row, 2 * image[i], unit);
        }
    }

    private static void Diagonalize(double[] diagonal, double[] beside, double[][] columns)
    {
        var n = diagonal.Length;
        var least = 0.0;
        for (var i = 0; i < n; i++)
        {
            least = Math.Max(least, Nothing * (Math.Abs(diagonal[i]) + Math.Abs(beside[i])));
        }

        for (var from = 0; from < n; from++)
        {
            for (var sweep = 0; sweep < MostSweeps; sweep++)
            {
                var to = from;
                while (to + 1 < n && Math.Abs(beside[to]) > Math.Max(least, 1e-16 * (Math.Abs(diagonal[to]) + Math.Abs(diagonal[to + 1]))))
                {
                    to++;
                }

                if (to == from)
                {
                    break;
                }

                Sweep(diagonal, beside, columns, from, to);
            }
        }
    }

    /// <summary>One step with a Wilkinson shift, from the end to the start of an unreduced block.</summary>
    private static void Sweep(double[] diagonal, double[] beside, double[][] columns, int from, int to)
    {
        var half = (diagonal[from + 1] - diagonal[from]) / (2 * beside[from]);
        var bulge = diagonal[to] - diagonal[from] + (beside[from] / (half + Math.CopySign(Math.Sqrt((half * half) + 1), half)));
        var (sine, cosine, shift) = (1.0, 1.0, 0.0);
        for (var i = to - 1; i >= from; i--)
        {
            var (f, b) = (sine * beside[i], cosine * beside[i]);
            var length = Math.Sqrt((f * f) + (bulge * bulge));
            beside[i + 1] = length;
            if (length == 0)
            {
                diagonal[i + 1] -= shift;
                beside[to] = 0;
                return;
            }

            (sine, cosine) = (f / length, bulge / length);
            var rest = diagonal[i + 1] - shift;
            var change = ((diagonal[i] - rest) * sine) + (2 * cosine * b);
            shift = sine * change;
            diagonal[i + 1] = rest + shift;
            bulge = (cosine * change) - b;
            ErrorMatching.Freeform.Vectors.Rotate(columns[i + 1], columns[i], cosine, sine);
        }

        diagonal[from] -= shift;
        beside[from] = bulge;
        beside[to] = 0;
    }
}
