namespace ErrorMatching.Freeform;

/// <summary>The lines of a rectangular grid of values.</summary>
/// <param name="U">Parameter of each line across u.</param>
/// <param name="V">Parameter of each line across v.</param>
/// <param name="Index">Number of the value on line i and line j, at i * V.Length + j.</param>
internal sealed record SampleGrid(double[] U, double[] V, int[] Index)
{
    /// <summary>How far a value may lie from its line, as a share of the distance of lines, where so many values could not be treated otherwise. A smooth error changes by as much of what it changes from line to line.</summary>
    private const double LooseTolerance = 0.02;

    private const double Tolerance = 1e-9;

    /// <summary>The grid of values on straight lines; null if they are on none.</summary>
    public static SampleGrid? Of(FieldData data)
    {
        if (!data.IsRectangular || data.Curves.Length < 2 || data.Crossings.Length < 2)
        {
            return null;
        }

        var u = data.Crossings.Select(line => line.Average(k => data.U[k])).ToArray();
        var v = data.Curves.Select(line => line.Average(k => data.V[k])).ToArray();
        var tolerance = data.Count > Covariance.MostScattered ? LooseTolerance : Tolerance;
        if (!Keeps(data.Crossings, data.U, u, tolerance) || !Keeps(data.Curves, data.V, v, tolerance))
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

    private static bool Keeps(int[][] lines, double[] values, double[] means, double tolerance)
    {
        for (var i = 0; i < lines.Length; i++)
        {
            var space = Math.Min(i > 0 ? means[i] - means[i - 1] : double.PositiveInfinity, i + 1 < lines.Length ? means[i + 1] - means[i] : double.PositiveInfinity);
            if (!(space > 0) || Array.Exists(lines[i], k => Math.Abs(values[k] - means[i]) > tolerance * space))
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
