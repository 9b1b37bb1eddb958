using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>What a dozen measured points can tell. Permutations and neighbors have no power among so few; the stated uncertainty of a point
/// is the yardstick.</summary>
internal static class FewPoints
{
    /// <summary>From this number on, the points themselves show what is noise; 5 by 6 still tell a rim from a chip.</summary>
    public const int Enough = 30;

    /// <summary>With fewer points, none can contradict the others.</summary>
    public const int LeastToContradict = LeftOutValues.LeastValues;

    /// <summary>With fewer points for each wave, another wave may look the same at the points.</summary>
    public const double LeastPerWave = 3;

    // Standard deviations, and root mean squares of what the other points show about their mean, beyond which a point does not belong to
    // them. Of 2,880 pieces with smooth errors none went beyond both. A bump that a single point sees does: what it is, only another
    // measurement tells.
    private const double Sigmas = 8;
    private const double Spreads = 2;

    // At most one point in this many may be outlying.
    private const int OneIn = 10;

    /// <summary>Probability that values of which nothing remains but noise of the stated uncertainty have so large a sum of
    /// squares.</summary>
    /// <param name="values">What remains of the values.</param>
    /// <param name="freedom">Degrees of freedom that were taken from them.</param>
    /// <param name="uncertainty">Standard uncertainty of one value; zero if unknown.</param>
    public static double ProbabilityOfNoise(IReadOnlyList<double> values, double freedom, double uncertainty)
    {
        var left = Math.Max(1, (int)Math.Floor(values.Count - freedom));
        return !(uncertainty > 0)
            ? 1
            : ChiSquaredDistribution.Above(values.Sum(x => x * x) / (uncertainty * uncertainty), left);
    }

    /// <summary>Returns the points that the others contradict, in sample order.</summary>
    /// <remarks>Each point is expected from the others alone, so that it cannot widen what they are taken to scatter by (the leave-one-out
    /// residual; Rasmussen and Williams, section 5.4.2). As many of the furthest as may be outlying are set aside, one after the other,
    /// because one hides another; then those that the rest does not contradict are put back.</remarks>
    /// <param name="samples">Fewer errors than <see cref="Enough"/>.</param>
    /// <param name="uncertainty">Standard uncertainty of one of them, above zero.</param>
    public static IReadOnlyList<OutlyingPoint> Outlying(IReadOnlyList<ErrorSample> samples, double uncertainty)
    {
        var data = FieldData.Of(samples);
        var aside = new List<int>();
        for (var most = Math.Min(Math.Max(1, data.Count / OneIn), data.Count - LeastToContradict + 1); aside.Count < most;)
        {
            aside.Add(Judge(data, [.. Kept(data, aside)], uncertainty).MaxBy(j => j.Sigmas).Point);
        }

        while (true)
        {
            var judged = aside.ConvertAll(k => Judge(data, [.. Kept(data, aside), k], uncertainty)[^1]);
            if (judged.TrueForAll(j => j.IsOutlying))
            {
                return [.. judged.OrderBy(j => j.Point).Select(j => new OutlyingPoint(samples[j.Point], j.Said))];
            }

            aside.Remove(judged.Where(j => !j.IsOutlying).MinBy(j => j.Sigmas).Point);
        }
    }

    private static IEnumerable<int> Kept(FieldData data, List<int> aside) =>
        Enumerable.Range(0, data.Count).Where(k => !aside.Contains(k));

    // How far each of some points is from what the others of them say.
    private static (int Point, double Said, double Sigmas, bool IsOutlying)[] Judge(FieldData data, int[] points, double uncertainty)
    {
        var values = data.Only(points);
        return [.. LeftOutValues.Expect(values, uncertainty).Select((expected, k) =>
        {
            var others = values.Z.Where((_, o) => o != k).ToArray();
            var (off, level) = (Math.Abs(values.Z[k] - expected.Mean), others.Average());
            var sigmas = off / expected.StandardDeviation;
            var spread = Math.Sqrt(others.Average(z => (z - level) * (z - level)));
            return (
                points[k], expected.Mean, sigmas, sigmas > Sigmas && off > OutlyingPoints.LeastMm && off > Spreads * spread);
        })];
    }
}
