namespace ErrorMatching.Freeform;

/// <summary>Functions at places, made orthonormal to a constant and to each other.</summary>
internal static class OrthonormalColumns
{
    // A column depends on the others if less than this share of its square remains.
    public const double Dependent = 1e-6;

    /// <summary>Returns the independent ones, orthonormal to a constant, to columns that are so already, and to each other.</summary>
    /// <param name="columns">The functions at the places.</param>
    /// <param name="others">Orthonormal columns.</param>
    public static double[][] Build(double[][] columns, double[][] others)
    {
        var result = new List<double[]>();
        foreach (var column in columns)
        {
            var rest = (double[])column.Clone();
            var before = Vectors.Dot(rest, rest);
            for (var round = 0; round < 2; round++)
            {
                var mean = rest.Average();
                for (var k = 0; k < rest.Length; k++)
                {
                    rest[k] -= mean;
                }

                foreach (var other in others.Concat(result))
                {
                    Vectors.Subtract(rest, Vectors.Dot(rest, other), other);
                }
            }

            var square = Vectors.Dot(rest, rest);
            if (square > before * Dependent)
            {
                LeastSquares.Scale(rest, 1 / Math.Sqrt(square));
                result.Add(rest);
            }
        }

        return [.. result];
    }
}
