namespace ErrorMatching.Geometry;

/// <summary>What poles and weights of curves and surfaces must be.</summary>
internal static class SplinePoles
{
    public static void Check(int expected, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights)
    {
        if (poles.Length != expected)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{poles.Length} poles; the knots need {expected}");
        }

        if (weights.Length != 0 && weights.Length != expected)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{weights.Length} weights; the poles need {expected}, or none");
        }

        for (var i = 0; i < poles.Length; i++)
        {
            if (!poles[i].IsFinite)
            {
                throw new GeometryException(GeometryError.NotFinite, $"pole {i + 1} has a coordinate that is no finite number");
            }
        }

        for (var i = 0; i < weights.Length; i++)
        {
            if (!double.IsFinite(weights[i]) || weights[i] <= 0)
            {
                throw new GeometryException(GeometryError.BadPoles, $"weight {i + 1} is not a positive finite number");
            }
        }
    }

    /// <summary>The weights, or null if they are all alike and so say nothing.</summary>
    public static double[]? Weights(ReadOnlySpan<double> weights) =>
        weights.Length == 0 || weights.IndexOfAnyExcept(weights[0]) < 0 ? null : weights.ToArray();
}
