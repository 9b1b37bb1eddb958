namespace ErrorMatching.Freeform;

/// <summary>Eigenvalues and eigenvectors of a symmetric matrix by Jacobi's cyclic rotations (Golub and Van Loan, Matrix Computations, 4th edition, section 8.5): small eigenvalues to the rounding of the largest.</summary>
internal sealed class SymmetricEigen
{
    private const int MostSweeps = 40;

    /// <summary>The decomposition of a symmetric matrix, which is used up.</summary>
    public SymmetricEigen(double[][] a)
    {
        var n = a.Length;
        Vectors = [.. Enumerable.Range(0, n).Select(i => Enumerable.Range(0, n).Select(j => i == j ? 1.0 : 0.0).ToArray())];
        var scale = a.Sum(row => row.Sum(x => x * x));
        for (var sweep = 0; sweep < MostSweeps; sweep++)
        {
            var off = 0.0;
            for (var p = 0; p < n; p++)
            {
                for (var q = p + 1; q < n; q++)
                {
                    off += a[p][q] * a[p][q];
                    Rotate(a, p, q);
                }
            }

            if (off <= 1e-32 * scale)
            {
                break;
            }
        }

        Values = [.. Enumerable.Range(0, n).Select(i => a[i][i])];
    }

    /// <summary>The eigenvalues, in no order.</summary>
    public double[] Values { get; }

    /// <summary>Row k is the unit eigenvector of eigenvalue k.</summary>
    public double[][] Vectors { get; }

    private void Rotate(double[][] a, int p, int q)
    {
        if (Math.Abs(a[p][q]) <= 1e-300)
        {
            return;
        }

        var half = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        var tangent = Math.CopySign(1 / (Math.Abs(half) + Math.Sqrt((half * half) + 1)), half);
        var cosine = 1 / Math.Sqrt((tangent * tangent) + 1);
        var sine = tangent * cosine;
        for (var k = 0; k < a.Length; k++)
        {
            (a[k][p], a[k][q]) = ((cosine * a[k][p]) - (sine * a[k][q]), (sine * a[k][p]) + (cosine * a[k][q]));
        }

        Turn(a[p], a[q], cosine, sine);
        Turn(Vectors[p], Vectors[q], cosine, sine);
    }

    private static void Turn(double[] p, double[] q, double cosine, double sine)
    {
        for (var k = 0; k < p.Length; k++)
        {
            (p[k], q[k]) = ((cosine * p[k]) - (sine * q[k]), (sine * p[k]) + (cosine * q[k]));
        }
    }
}
