namespace ErrorMatching.Freeform;

/// <summary>Finds the kernel of greatest likelihood: the best of a few starts, then a simplex. The same values give the same kernel.</summary>
internal static class ProcessSearch
{
    /// <summary>Lines of a grid in one direction from which the kernel is estimated at most; the process itself uses all.</summary>
    private const int MostLines = 20;

    private const int MostEvaluations = 140;

    /// <summary>The process with the best kernel; null if the values are too few or too many.</summary>
    public static ProcessModel? Run(FieldData data, Term[] trend)
    {
        if (!Covariance.IsPossible(data) || data.Count < trend.Length + 5)
        {
            return null;
        }

        var few = data.Thinned(MostLines);
        double[]? best = null;
        var least = double.PositiveInfinity;
        foreach (var length in (ReadOnlySpan<double>)[0.3, 0.8, 2])
        {
            foreach (var noise in (ReadOnlySpan<double>)[-10, -4, -1])
            {
                double[] start = [Math.Log(length), Math.Log(length), noise];
                var value = Cost(few, start, trend);
                (best, least) = value < least ? (start, value) : (best, least);
            }
        }

        return best is null ? null : ProcessModel.Fit(data, KernelOf(Simplex.Minimum(x => Cost(few, x, trend), best, 0.7, MostEvaluations, 1e-3)), trend);
    }

    /// <summary>The terms up to a total degree.</summary>
    public static Term[] Trend(int degree) =>
        [.. from a in Enumerable.Range(0, degree + 1) from b in Enumerable.Range(0, degree + 1 - a) select new Term(new(a), new(b))];

    private static double Cost(FieldData data, double[] x, Term[] trend) => -(ProcessModel.Fit(data, KernelOf(x), trend)?.Likelihood ?? double.NegativeInfinity);

    private static Kernel KernelOf(double[] x) =>
        new(Math.Exp(Math.Clamp(x[0], -3, 3)), Math.Exp(Math.Clamp(x[1], -3, 3)), Math.Pow(10, Math.Clamp(x[2], -13, 2)));
}
