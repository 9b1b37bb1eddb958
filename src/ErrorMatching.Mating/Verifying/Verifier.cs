using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Compares counterparts with the part (Wang 2021, section 4): the deviations of every feature, the quantities of its kind
/// (length of a line, angle of a triangle), and the comparisons that the job requests.</summary>
internal static class Verifier
{
    /// <summary>Compares two counterparts with the part.</summary>
    /// <param name="job">The job.</param>
    /// <param name="points">For each feature of the job, in its order, the key points in the order of cutting.</param>
    /// <param name="isBeforeMeasured">False if the counterpart before is the designed one, which has no uncertainty.</param>
    /// <exception cref="ArgumentException">The lists do not match the job's features and points.</exception>
    /// <exception cref="GeometryException">The points of a feature do not determine it; the message names the feature.</exception>
    public static VerificationResult Verify(
        MatingJob job, IReadOnlyList<IReadOnlyList<VerifiedPoint>> points, bool isBeforeMeasured = true)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(points);
        if (!job.KeyPoints.SequenceEqual(points.SelectMany(p => p).Select(p => p.Label)))
        {
            throw new ArgumentException(
                "Found other points than the job's; expected its key points in the order of cutting.", nameof(points));
        }

        VerifiedPoint[] all = [.. points.SelectMany(p => p)];
        var byLabel = all.ToDictionary(p => p.Label, StringComparer.Ordinal);
        var u = job.Gauge.Uncertainty.CombinedMm * (isBeforeMeasured ? Math.Sqrt(2) : 1);
        return new(
            all,
            [.. job.Features.SelectMany(f => OfFeature(f, byLabel, u)), .. job.Verify.Select(c => OfComparison(c, job, byLabel, u))]);
    }

    private static List<VerifiedFeature> OfFeature(JobFeature feature, Dictionary<string, VerifiedPoint> byLabel, double u)
    {
        var points = Select(feature.Points, byLabel);
        return
        [
            Deviation(feature.Name, false, points, u),
            Deviation(feature.Name, true, points, u),
            .. feature.Compared.Select(c => Of(feature.Name, c.Quantity, at => c.Of([.. points.Select(at)]), points, u)),
        ];
    }

    private static VerifiedFeature OfComparison(
        JobComparison comparison, MatingJob job, Dictionary<string, VerifiedPoint> byLabel, double u)
    {
        if (comparison is DeviationComparison deviation)
        {
            return Deviation(comparison.Name, deviation.AlongX, Select(deviation.Points, byLabel), u);
        }

        var angle = (AngleComparison)comparison;
        return Of(
            comparison.Name,
            VerifiedQuantity.Angle,
            at => FeatureFits.Inside(Element(angle.First, job, byLabel, at), Element(angle.Second, job, byLabel, at)).Degrees,
            byLabel.Values,
            u);
    }

    private static LineFit Element(
        ElementReference reference, MatingJob job, Dictionary<string, VerifiedPoint> byLabel, Func<VerifiedPoint, Point2> at)
    {
        var feature = job.Features.First(f => f.Name == reference.Feature);
        var element = feature.Element(reference.Flank)
            ?? throw new ArgumentException($"Found {reference}, which is not straight; expected a line or a flank.", nameof(reference));
        return FeatureFits.Line(feature.Name, element.Method, [.. Select(element.Points, byLabel).Select(at)], 0);
    }

    // A largest deviation is that of one coordinate of one point.
    private static VerifiedFeature Deviation(string name, bool alongX, IReadOnlyList<VerifiedPoint> points, double u)
    {
        var deviation = VerifiedFeature.DeviationOf(name, points) with { ChangeUncertainty = u };
        return !alongX ? deviation : deviation with
        {
            Quantity = VerifiedQuantity.DeviationX,
            Before = points.Max(p => Math.Abs(p.BeforeError.Vector.X)),
            After = points.Max(p => Math.Abs(p.AfterError.Vector.X)),
        };
    }

    private static VerifiedFeature Of(
        string name,
        VerifiedQuantity quantity,
        Func<Func<VerifiedPoint, Point2>, double> value,
        IReadOnlyCollection<VerifiedPoint> points,
        double u) =>
        new(name, quantity, value(p => p.Part), value(p => p.Before), value(p => p.After))
        {
            ChangeUncertainty = Propagated(value, points, u)
        };

    // First order: each coordinate of each point off by its uncertainty, one at a time.
    private static double Propagated(
        Func<Func<VerifiedPoint, Point2>, double> value, IReadOnlyCollection<VerifiedPoint> points, double u)
    {
        var at = value(p => p.After);
        return Math.Sqrt(points.SelectMany(p => new[] { (Point: p, By: new Vector2(u, 0)), (Point: p, By: new Vector2(0, u)) }).Sum(
            m => Elementary.Pow(value(p => p.Label == m.Point.Label ? p.After + m.By : p.After) - at, 2)));
    }

    private static VerifiedPoint[] Select(IReadOnlyList<string> labels, Dictionary<string, VerifiedPoint> byLabel) =>
        [.. labels.Select(l => byLabel[l])];
}
