using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The scatter of the measured points about a smooth course, divided by the stated standard uncertainty.</summary>
/// <param name="Ratio">The ratio.</param>
/// <param name="From">Lower end of its 95 % interval; 0 if the points may not scatter at all.</param>
/// <param name="To">Upper end of its 95 % interval.</param>
public sealed record ScatterRatio(double Ratio, double From, double To)
{
    // A run of fewer points says next to nothing of a scatter.
    private const int Fewest = 7;

    // The ratios that are tried: from an eighth to eight times, four steps to a doubling.
    private const int Steps = 24;
    private const double Least = 0.125, Step = 1.189207115002721;

    /// <summary>True if the points scatter by more than what is stated: intervals and risk are too small.</summary>
    public bool IsTooMuch => From > 1;

    /// <summary>True if they scatter by less: intervals and risk are larger than they need be, unless errors are shared by all points,
    /// which no scatter shows.</summary>
    public bool IsTooLittle => To < 1;

    /// <summary>The ratio that explains the points best; null if they do not tell one.</summary>
    /// <remarks>The evidence of the values for each ratio, with the scales of the course chosen again for each (Rasmussen and Williams
    /// 2006, section 5.4.1), as a density over the logarithm of the ratio.</remarks>
    /// <param name="runs">The stretches of each run, and what its key points say.</param>
    /// <param name="uncertaintyMm">The stated standard uncertainty.</param>
    internal static ScatterRatio? Estimate(
        IReadOnlyList<(IReadOnlyList<Stretch> Stretches, BoundaryRow[] Rows)> runs, double uncertaintyMm)
    {
        var told = runs.Where(r => r.Rows.Length >= Fewest && r.Stretches.Count > 0).ToArray();
        if (told.Length == 0 || uncertaintyMm <= DeviationField.LeastUncertaintyMm)
        {
            return null;
        }

        var ratios = new double[Steps + 1];
        var logs = new double[Steps + 1];
        for (var k = 0; k <= Steps; k++)
        {
            ratios[k] = k == 0 ? Least : ratios[k - 1] * Step;
            foreach (var (stretches, rows) in told)
            {
                var noise = ratios[k] * uncertaintyMm;
                logs[k] += Evidence.Log(
                    DeviationField.CovarianceOf(PriorChoice.Of(stretches, rows, noise).OfPiece, rows, noise),
                    [.. rows.Select(r => r.ValueMm)]);
            }
        }

        var best = logs.Max();
        double[] weights = [.. logs.Select(l => Elementary.Exp(l - best))];
        var sum = weights.Sum();
        var mean = Elementary.Exp(Enumerable.Range(0, Steps + 1).Sum(k => weights[k] / sum * Elementary.Log(ratios[k])));
        var (from, to) = (Quantile(0.025), Quantile(0.975));
        return new(mean, from <= Least * Step ? 0 : from, to);

        double Quantile(double share)
        {
            var reached = 0.0;
            for (var k = 0; k <= Steps; k++)
            {
                reached += weights[k] / sum;
                if (reached >= share)
                {
                    return ratios[k];
                }
            }

            return ratios[Steps];
        }
    }

    internal void Write(ReportWriter w)
    {
        w.Number("ratio", Ratio);
        w.Numbers("interval95", [From, To]);
    }

    internal static ScatterRatio Read(ReportReader r) => r.Numbers("interval95") is [var from, var to]
        ? new(r.Number("ratio"), from, to)
        : throw r.Refusal("interval95", "wrong-type", "two numbers");
}
