namespace ErrorMatching.Geometry;

/// <summary>
/// Polynomials that are orthogonal over the given points, made one degree after the other by Forsythe's three-term recurrence
/// (G. E. Forsythe, "Generation and use of orthogonal polynomials for data-fitting with a digital computer", J. SIAM 5, 1957), in double-double,
/// together with the projection of the ordinates on each and what it leaves.
/// </summary>
/// <remarks>
/// On the abscissa mapped to [-1, 1] by <c>t = (x - center) / halfWidth</c> the recurrence is <c>p[k+1] = (t - a[k]) p[k] - b[k] p[k-1]</c> with
/// <c>a = (t p, p) / (p, p)</c> and <c>b = (p[k], p[k]) / (p[k-1], p[k-1])</c>. The least-squares coefficient of each is independent of the others, so
/// one pass serves all degrees.
/// </remarks>
internal sealed class ForsytheBasis
{
    private ForsytheBasis(double center, double halfWidth, int count)
    {
        (Center, HalfWidth) = (center, halfWidth);
        A = new DoubleDouble[count];
        B = new DoubleDouble[count];
        SquaredNorms = new DoubleDouble[count];
        Coefficients = new DoubleDouble[count];
        Values = new DoubleDouble[count][];
        Residuals = new DoubleDouble[count][];
    }

    public double Center { get; }

    public double HalfWidth { get; }

    /// <summary>Shift of the recurrence that leads from degree k to k + 1.</summary>
    public DoubleDouble[] A { get; }

    /// <summary>Weight of degree k - 1 in the recurrence that leads from degree k to k + 1.</summary>
    public DoubleDouble[] B { get; }

    /// <summary>Sum of squares of each polynomial over the points.</summary>
    public DoubleDouble[] SquaredNorms { get; }

    /// <summary>Least-squares coefficient of each polynomial.</summary>
    public DoubleDouble[] Coefficients { get; }

    /// <summary>Each polynomial at each point.</summary>
    public DoubleDouble[][] Values { get; }

    /// <summary>What the plain fit of each degree leaves at each point.</summary>
    public DoubleDouble[][] Residuals { get; }

    /// <summary>The basis up to a degree for points sorted by abscissa, of which more differ than the degree says.</summary>
    public static ForsytheBasis Build(DoubleDouble[] x, DoubleDouble[] y, int degree)
    {
        var halfWidth = ((x[^1] - x[0]) * 0.5).ToDouble();
        var basis = new ForsytheBasis(((x[0] + x[^1]) * 0.5).ToDouble(), halfWidth > 0 ? halfWidth : 1, degree + 1);
        basis.Fill(x, y);
        return basis;
    }

    /// <summary>
    /// Each polynomial in powers of x as given: row k holds the ascending coefficients of degree k. The recurrence is run on the coefficients, in double-double,
    /// where the far larger powers of an unmapped abscissa cancel without harm.
    /// </summary>
    public DoubleDouble[][] InPowersOfX(int degree) => Powers(degree, Center, HalfWidth);

    /// <summary>Each polynomial in powers of the mapped abscissa.</summary>
    public DoubleDouble[][] InPowersOfT(int degree) => Powers(degree, 0, 1);

    private DoubleDouble[][] Powers(int degree, double center, double halfWidth)
    {
        var rows = new DoubleDouble[degree + 1][];
        rows[0] = [DoubleDouble.One];
        var scale = DoubleDouble.One / halfWidth;
        for (var k = 0; k < degree; k++)
        {
            var next = new DoubleDouble[k + 2];
            var shift = ((DoubleDouble)center * scale) + A[k];
            for (var j = 0; j <= k; j++)
            {
                next[j + 1] += rows[k][j] * scale;
                next[j] -= rows[k][j] * shift;
            }

            for (var j = 0; j < k; j++)
            {
                next[j] -= rows[k - 1][j] * B[k];
            }

            rows[k + 1] = next;
        }

        return rows;
    }

    private void Fill(DoubleDouble[] x, DoubleDouble[] y)
    {
        var n = x.Length;
        var t = new DoubleDouble[n];
        var current = new DoubleDouble[n];
        for (var i = 0; i < n; i++)
        {
            t[i] = (x[i] - Center) / HalfWidth;
            current[i] = DoubleDouble.One;
        }

        var rest = y;
        for (var k = 0; k < Values.Length; k++)
        {
            DoubleDouble norm = 0, moment = 0, projection = 0;
            for (var i = 0; i < n; i++)
            {
                var square = current[i] * current[i];
                norm += square;
                moment += t[i] * square;
                projection += rest[i] * current[i];
            }

            Values[k] = current;
            SquaredNorms[k] = norm;
            A[k] = moment / norm;
            B[k] = k == 0 ? DoubleDouble.Zero : norm / SquaredNorms[k - 1];
            Coefficients[k] = projection / norm;
            var left = new DoubleDouble[n];
            for (var i = 0; i < n; i++)
            {
                left[i] = rest[i] - (Coefficients[k] * current[i]);
            }

            Residuals[k] = rest = left;
            if (k + 1 < Values.Length)
            {
                current = Next(t, k);
            }
        }
    }

    private DoubleDouble[] Next(DoubleDouble[] t, int k)
    {
        var next = new DoubleDouble[t.Length];
        for (var i = 0; i < next.Length; i++)
        {
            next[i] = (t[i] - A[k]) * Values[k][i];
            if (k > 0)
            {
                next[i] -= B[k] * Values[k - 1][i];
            }
        }

        return next;
    }
}
