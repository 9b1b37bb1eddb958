using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Tells deviations from the noise of the gauge: those of single points, with one threshold for all points of a job, and what
/// points have in common.</summary>
/// <remarks>
/// <para>A point alarms if its deviation is outside the acceptance limits and exceeds k times its standard uncertainty u. On a perfect
/// part it does so with the probability P(k), by the normal distribution. k is the smallest factor for which the points of the whole job
/// stay silent together with at least 95.05 %: the product of 1 - P(k) over all of them (Sidak 1967). A point whose limits alone keep it
/// silent costs nothing, so k is 0 if all limits are wide beside u. For N points with limits narrower than k u,
/// k = z((1 + 0.9505^(1/N)) / 2): 2.24 for 2 points, 2.69 for 7, 2.96 for 16.</para>
/// <para>Errors that points have in common (temperature, clamping) make fewer alarms, not more: the product is a lower bound for any
/// correlation of normal errors if the limits are symmetric. For others, the alarms of a job stay below -ln 0.9505 = 5.08 % (the sum of
/// P(k)).</para>
/// <para>All points may be off by less than any one shows: sixteen points that are off by 2 u each are 8 standard deviations together. So
/// the growth, the shift in x and y and the turn of each feature, and of all features together that no point or feature of their own makes
/// significant, are tested too, with 0.05 % for all of these. Each is a sum of the deviations that the sums before it do not explain. Its
/// standard deviation has the independent part of u, and the part that all points share as a growth, as far as the job states one: what is
/// shared and not stated makes false alarms (method, section 13).</para>
/// <para>Against a single deviating point at an unknown place, no test of this size has a noticeably higher power (Neyman and Pearson's
/// for 3.5 u: 0.73 instead of 0.72 for 16 points).</para>
/// </remarks>
internal static class Significance
{
    /// <summary>Largest probability that a job is compensated although its part is perfect.</summary>
    public const double FalseAlarms = 0.05;

    // What all points have in common is seen by a hundredth of that: its deviations grow with the root of the number of points.
    private const double OfTogether = 0.0005;

    // The rest of a sum that the sums before it explain, as a part of it.
    private const double LeastRest = 0.05;

    // Beyond 9 u lie 2e-19 of all values: a threshold for any number of points.
    private const double MostFactor = 9;
    private const double Precision = 1e-9;

    /// <summary>The factor k.</summary>
    /// <param name="features">The acceptance limits of each feature and the number of its points.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty u of a deviation.</param>
    public static double Factor(IReadOnlyList<(ToleranceBand Acceptance, int Points)> features, double standardUncertaintyMm)
    {
        if (standardUncertaintyMm == 0 || IsSilent(features, standardUncertaintyMm, 0))
        {
            return 0;
        }

        var (loud, silent) = (0.0, MostFactor);
        while (silent - loud > Precision)
        {
            var middle = (loud + silent) / 2;
            (loud, silent) = IsSilent(features, standardUncertaintyMm, middle) ? (loud, middle) : (middle, silent);
        }

        return silent;
    }

    private static bool IsSilent(IReadOnlyList<(ToleranceBand Acceptance, int Points)> features, double u, double factor) =>
        features.Sum(f => f.Points * Elementary.Log(1 - Alarm(f.Acceptance.LowerMm / u, f.Acceptance.UpperMm / u, factor)))
            >= Elementary.Log(1 - (FalseAlarms - OfTogether));

    /// <summary>Which features are significantly off by what their points have in common, or all of them together.</summary>
    /// <param name="features">The points of each feature.</param>
    /// <param name="alone">Which features have a significant point: they say nothing of the others.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty u of a deviation.</param>
    /// <param name="sharedMm">The part of u that all deviations share.</param>
    public static bool[] Together(
        IReadOnlyList<IReadOnlyList<SignificantPoint>> features, IReadOnlyList<bool> alone, double standardUncertaintyMm, double sharedMm)
    {
        var own = features.Select(f => Sums(f, standardUncertaintyMm, sharedMm)).ToArray();
        var ofAll = features.Count > 1 ? Sums([.. features.SelectMany(f => f)], standardUncertaintyMm, sharedMm).Count : 0;
        var tests = own.Sum(s => s.Count) + ofAll;
        var most = NormalDistribution.Quantile((1 + Elementary.Pow(1 - OfTogether, 1.0 / Math.Max(1, tests))) / 2);
        bool[] found = [.. own.Select((s, f) => alone[f] || s.Any(z => Math.Abs(z) > most))];
        int[] left = [.. Enumerable.Range(0, found.Length).Where(f => !found[f])];
        if (left.Length > 1 && Sums([.. left.SelectMany(f => features[f])], standardUncertaintyMm, sharedMm).Any(z => Math.Abs(z) > most))
        {
            Array.Fill(found, true);
        }

        return found;
    }

    // The growth, the shift and the turn of some points in standard deviations, each less what the ones before it explain.
    private static List<double> Sums(IReadOnlyList<SignificantPoint> points, double u, double sharedMm)
    {
        var sums = new List<double>();
        if (points.Count < 2)
        {
            return sums;
        }

        var middle = new Point2(points.Average(p => p.Place.X), points.Average(p => p.Place.Y));
        var size = Math.Max(points.Max(p => (p.Place - middle).Length), 1e-9);
        var before = new List<double[]>();
        foreach (var row in (Func<SignificantPoint, double>[])[
            _ => 1, p => p.Normal.X, p => p.Normal.Y, p => (p.Place - middle).Cross(p.Normal) / size])
        {
            double[] weights = [.. points.Select(row)];
            var whole = Length(weights);
            foreach (var other in before)
            {
                var part = weights.Zip(other, (w, o) => w * o).Sum();
                weights = [.. weights.Zip(other, (w, o) => w - (part * o))];
            }

            var length = Length(weights);
            if (length < LeastRest * Math.Max(whole, Math.Sqrt(points.Count) * LeastRest))
            {
                continue;
            }

            weights = [.. weights.Select(w => w / length)];
            before.Add(weights);
            var shared = weights.Sum() * sharedMm;
            sums.Add(weights.Zip(points, (w, p) => w * p.Mm).Sum()
                / Math.Max(Math.Sqrt(Math.Max(0, (u * u) - (sharedMm * sharedMm)) + (shared * shared)), UncertaintyBudget.LeastMm));
        }

        return sums;

        static double Length(double[] weights) => Math.Sqrt(weights.Sum(w => w * w));
    }

    // The probability of a standard normal value outside the limits and beyond the factor on either side.
    private static double Alarm(double lower, double upper, double factor) =>
        Beyond(factor, lower, upper) + Beyond(factor, -upper, -lower);

    // The part of it above the factor.
    private static double Beyond(double factor, double lower, double upper)
    {
        var beyond = NormalDistribution.Below(-factor);
        var from = Math.Max(lower, factor);
        return upper <= from ? beyond : beyond - NormalDistribution.Below(-from) + NormalDistribution.Below(-upper);
    }
}

/// <summary>A point whose deviation may be significant.</summary>
/// <param name="Place">Where it is.</param>
/// <param name="Normal">Unit normal of the boundary there.</param>
/// <param name="Mm">Its deviation along the normal, mm.</param>
internal readonly record struct SignificantPoint(Point2 Place, Vector2 Normal, double Mm)
{
    public static SignificantPoint Of(BoundaryPoint point) => new(point.Wanted, point.Normal, point.FollowedMm);
}
