namespace ErrorMatching.Freeform;

/// <summary>Solves small symmetric systems that may leave unknowns undetermined.</summary>
internal static class SmallSymmetric
{
    /// <summary>The shortest least-squares solution: directions with an eigenvalue below a share of the largest stay zero.</summary>
    /// <remarks>Eigenvectors by Jacobi's rotations (Golub and Van Loan, Matrix Computations, 4th edition, section 8.5).</remarks>
    public static double[] Solve(double[,] matrix, double[] right, double share)
    {
        var n = right.Length;
        var a = (double[,])matrix.Clone();
        var vectors = new double[n, n];
        for (var i = 0; i < n; i++)
        {
            vectors[i, i] = 1;
        }

        for (var sweep = 0; sweep < 50; sweep++)
        {
            for (var p = 0; p < n; p++)
            {
                for (var q = p + 1; q < n; q++)
                {
                    Rotate(a, vectors, p, q);
                }
            }
        }

        var largest = Enumerable.Range(0, n).Max(i => a[i, i]);
        var result = new double[n];
        for (var k = 0; k < n; k++)
        {
            if (a[k, k] <= share * largest)
            {
                continue;
            }

            var along = 0.0;
            for (var i = 0; i < n; i++)
            {
                along += vectors[i, k] * right[i];
            }

            for (var i = 0; i < n; i++)
            {
                result[i] += vectors[i, k] * along / a[k, k];
            }
        }

        return result;
    }

    private static void Rotate(double[,] a, double[,] vectors, int p, int q)
    {
        if (a[p, q] == 0)
        {
            return;
        }

        var n = a.GetLength(0);
        var theta = (a[q, q] - a[p, p]) / (2 * a[p, q]);
        var t = (theta >= 0 ? 1 : -1) / (Math.Abs(theta) + Math.Sqrt((theta * theta) + 1));
        var c = 1 / Math.Sqrt((t * t) + 1);
        var s = t * c;
        for (var i = 0; i < n; i++)
        {
            (a[i, p], a[i, q]) = ((c * a[i, p]) - (s * a[i, q]), (s * a[i, p]) + (c * a[i, q]));
        }

        for (var i = 0; i < n; i++)
        {
            (a[p, i], a[q, i]) = ((c * a[p, i]) - (s * a[q, i]), (s * a[p, i]) + (c * a[q, i]));
            (vectors[i, p], vectors[i, q]) = ((c * vectors[i, p]) - (s * vectors[i, q]), (s * vectors[i, p]) + (c * vectors[i, q]));
        }
    }
}
