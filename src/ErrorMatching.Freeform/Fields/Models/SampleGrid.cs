namespace ErrorMatching.Freeform;

/// <summary>The lines of a rectangular grid of values.</summary>
/// <param name="U">Parameter of each line across u.</param>
/// <param name="V">Parameter of each line across v.</param>
/// <param name="Index">Index of the value on line i and line j, at i * V.Length + j.</param>
internal sealed record SampleGrid(double[] U, double[] V, int[] Index)
{
    /// <summary>Largest distance of a value from its line, as a share of the line spacing.</summary>
    private const double Tolerance = 1e-9;

    /// <summary>The tolerance if there are too many values to treat as scattered, and moving them to their lines changes none by more than
    /// <see cref="Harmless"/>.</summary>
    private const double LooseTolerance = 0.02;

    private const double Harmless = 1e-5;

    /// <summary>Returns the grid of values on straight lines; null if there is none.</summary>
    public static SampleGrid? Of(FieldData data)
    {
        if (!data.IsRectangular || data.Curves.Length < 2 || data.Crossings.Length < 2)
        {
            return null;
        }

        var u = data.Crossings.Select(line => line.Average(k => data.U[k])).ToArray();
        var v = data.Curves.Select(line => line.Average(k => data.V[k])).ToArray();
        var tolerance = data.Count > Covariance.MostScattered ? LooseTolerance : Tolerance;
        // The slope of smooth values is a few times their range divided by the extent, which is 2.
        var most = tolerance == Tolerance ? double.PositiveInfinity : Harmless / Math.Max(double.Epsilon, data.Z.Max() - data.Z.Min());
        if (!Keeps(data.Crossings, data.U, u, tolerance, most) || !Keeps(data.Curves, data.V, v, tolerance, most))
        {
            return null;
        }

        var row = new int[data.Count];
        var column = new int[data.Count];
        Number(data.Crossings, row);
        Number(data.Curves, column);
        var index = new int[data.Count];
        for (var k = 0; k < index.Length; k++)
        {
            index[(row[k] * v.Length) + column[k]] = k;
        }

        return new(u, v, index);
    }

    private static bool Keeps(int[][] lines, double[] values, double[] means, double tolerance, double most)
    {
        for (var i = 0; i < lines.Length; i++)
        {
            var space = Math.Min(
                i > 0 ? means[i] - means[i - 1] : double.PositiveInfinity,
                i + 1 < lines.Length ? means[i + 1] - means[i] : double.PositiveInfinity);
            if (!(space > 0)
                || Array.Exists(
                    lines[i], k => Math.Abs(values[k] - means[i]) > Math.Max(Tolerance * space, Math.Min(tolerance * space, most))))
            {
                return false;
            }
        }

        return true;
    }

    private static void Number(int[][] lines, int[] result)
    {
        for (var i = 0; i < lines.Length; i++)
        {
            foreach (var k in lines[i])
            {
                result[k] = i;
            }
        }
    }
}
