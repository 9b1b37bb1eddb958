using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>What a few values say of each one from all others: the mean of Gaussian processes about one level, each weighed by how likely
/// it makes the others.</summary>
/// <remarks>A dozen values do not tell the lengths of a field from its noise. The likeliest kernel alone is then often a poor one, and the
/// spread among the likely ones belongs to the uncertainty (Rasmussen and Williams, Gaussian Processes for Machine Learning, section 5.2).
/// The weight is the restricted likelihood of the others at the variance that they show, or at the least variance with which the noise is
/// not below the stated uncertainty. With Q the inverse covariance without the part along the level, a value differs from what the others
/// say by [Q z]_i / Q_ii; z'Q z becomes smaller by [Q z]_i^2 / Q_ii without it, and the logarithm of the determinant larger by that of
/// Q_ii (section 5.4.2), so that no kernel has to be factored again for each value.</remarks>
internal static class LeftOutValues
{
    /// <summary>The fewest values of which each is expected from the others.</summary>
    public const int LeastValues = 6;

    // Lengths over which places are alike, on axes of length 2, and variances of the noise as shares of that of the process.
    private static readonly double[] Lengths = [0.5, 1, 2, 4];
    private static readonly double[] Noises = [1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1, 10];

    /// <summary>Returns the value expected at each place, and the standard deviation of one that is measured there: of the expectation, and
    /// of noise.</summary>
    /// <param name="data">The values, at least <see cref="LeastValues"/>.</param>
    /// <param name="uncertainty">Stated standard uncertainty of one value, above zero.</param>
    public static (double Mean, double StandardDeviation)[] Expect(FieldData data, double uncertainty)
    {
        var n = data.Count;
        var found = (from u in Lengths from v in Lengths from noise in Noises select Under(data, new(u, v, noise), uncertainty)).ToArray();
        return [.. Enumerable.Range(0, n).Select(k =>
        {
            var best = found.Max(f => f[k].Likelihood);
            var (sum, mean, square) = (0.0, 0.0, 0.0);
            foreach (var of in found)
            {
                var weight = Elementary.Exp(of[k].Likelihood - best);
                sum += weight;
                mean += weight * of[k].Mean;
                square += weight * ((of[k].Mean * of[k].Mean) + of[k].Variance);
            }

            mean /= sum;
            return (mean, Math.Sqrt(Math.Max(uncertainty * uncertainty, (square / sum) - (mean * mean))));
        })];
    }

    // Each value under one kernel. All kernels have enough noise for double precision.
    private static (double Likelihood, double Mean, double Variance)[] Under(FieldData data, Kernel kernel, double uncertainty)
    {
        var n = data.Count;
        var rows = new double[n][];
        for (var i = 0; i < n; i++)
        {
            rows[i] = [.. Enumerable.Range(0, i + 1).Select(j =>
                (kernel.AlongU(data.U[i], data.U[j]) * kernel.AlongV(data.V[i], data.V[j])) + (i == j ? kernel.Noise : 0))];
        }

        var factor = BandedCholesky.Factor(rows, n)!;
        var inverse = Enumerable.Range(0, n).Select(i => factor.Solve([.. Enumerable.Range(0, n).Select(j => i == j ? 1.0 : 0)])).ToArray();
        double[] level = [.. inverse.Select(row => row.Sum())];
        var total = level.Sum();
        double Q(int i, int j) => inverse[i][j] - (level[i] * level[j] / total);

        // Values about their mean: nothing changes, and digits are preserved.
        var (mean, free) = (data.Z.Average(), n - 2);
        double[] z = [.. data.Z.Select(x => x - mean)];
        double[] weighed = [.. Enumerable.Range(0, n).Select(i => Enumerable.Range(0, n).Sum(j => Q(i, j) * z[j]))];
        var form = LeastSquares.Product(weighed, z);
        var determinants = factor.LogDeterminant + Elementary.Log(total);
        return [.. Enumerable.Range(0, n).Select(i =>
        {
            var own = Q(i, i);
            var shown = Math.Max(form - (weighed[i] * weighed[i] / own), 1e-26) / free;
            var variance = Math.Max(shown, uncertainty * uncertainty / kernel.Noise);
            return (
                -0.5 * ((free * (Elementary.Log(variance) + (shown / variance))) + determinants + Elementary.Log(own)),
                data.Z[i] - (weighed[i] / own),
                variance / own);
        })];
    }
}
