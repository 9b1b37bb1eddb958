namespace ErrorMatching.Freeform;

/// <summary>The Cholesky factor of a few columns less their means, without columns that depend on those before them. It tells what share of
/// the squares of values they explain from their products alone.</summary>
internal sealed class CenteredFactor
{
    /// <summary>Maximum number of columns.</summary>
    public const int Most = 4;

    private readonly double[] _rows = new double[Most * Most];
    private readonly bool[] _isKept = new bool[Most];

    /// <summary>Number of independent columns.</summary>
    public int Rank { get; }

    /// <summary>Factors columns.</summary>
    public CenteredFactor(double[][] columns)
    {
        var centered = Array.ConvertAll(columns, Centered);
        for (var k = 0; k < columns.Length; k++)
        {
            var row = _rows.AsSpan(k * Most, Most);
            var rest = Vectors.Dot(centered[k], centered[k]);
            for (var m = 0; m < k; m++)
            {
                if (_isKept[m])
                {
                    var before = _rows.AsSpan(m * Most, Most);
                    row[m] = (Vectors.Dot(centered[k], centered[m]) - Vectors.Dot(row[..m], before)) / before[m];
                    rest -= row[m] * row[m];
                }
            }

            if (rest > Vectors.Dot(columns[k], columns[k]) * OrthonormalColumns.Dependent)
            {
                (row[k], _isKept[k]) = (Math.Sqrt(rest), true);
                Rank++;
            }
        }
    }

    /// <summary>The part of the squares of values that the columns explain.</summary>
    /// <param name="products">The products of values of mean 0 with each column.</param>
    public double Share(ReadOnlySpan<double> products)
    {
        Span<double> parts = stackalloc double[Most];
        var share = 0.0;
        for (var m = 0; m < products.Length; m++)
        {
            if (_isKept[m])
            {
                var row = _rows.AsSpan(m * Most, Most);
                parts[m] = (products[m] - Vectors.Dot(row[..m], parts)) / row[m];
                share += parts[m] * parts[m];
            }
        }

        return share;
    }

    private static double[] Centered(double[] column)
    {
        var mean = column.Average();
        return Array.ConvertAll(column, x => x - mean);
    }
}
