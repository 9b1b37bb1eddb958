using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Compares counterparts with the part (Wang 2021, section 4): the deviations of every feature, the quantities of its kind
/// (length of a line, angle of a triangle), and the comparisons that the job requests.</summary>
internal static class Verifier
{
    /// <summary>Compares two counterparts with the part.</summary>
    /// <param name="job">The job.</param>
    /// <param name="points">For each feature of the job, in its order, the key points in the order of cutting.</param>
    /// <exception cref="ArgumentException">The lists do not match the job's features and points.</exception>
    /// <exception cref="GeometryException">The points of a feature do not determine it; the message names the feature.</exception>
    public static VerificationResult Verify(MatingJob job, IReadOnlyList<IReadOnlyList<VerifiedPoint>> points)
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
        return new(all, [.. job.Features.SelectMany(f => OfFeature(f, byLabel)), .. job.Verify.Select(c => OfComparison(c, job, byLabel))]);
    }

    private static List<VerifiedFeature> OfFeature(JobFeature feature, Dictionary<string, VerifiedPoint> byLabel)
    {
        var points = Select(feature.Points, byLabel);
        return
        [
            Deviation(feature.Name, false, points),
            Deviation(feature.Name, true, points),
            .. feature.Compared.Select(c => Of(feature.Name, c.Quantity, at => c.Of([.. points.Select(at)]))),
        ];
    }

    private static VerifiedFeature OfComparison(JobComparison comparison, MatingJob job, Dictionary<string, VerifiedPoint> byLabel)
    {
        if (comparison is DeviationComparison deviation)
        {
            return Deviation(comparison.Name, deviation.AlongX, Select(deviation.Points, byLabel));
        }

        var angle = (AngleComparison)comparison;
        return Of(
            comparison.Name,
            VerifiedQuantity.Angle,
            at => FeatureFits.Inside(Element(angle.First, job, byLabel, at), Element(angle.Second, job, byLabel, at)).Degrees);
    }

    private static LineFit Element(
        ElementReference reference, MatingJob job, Dictionary<string, VerifiedPoint> byLabel, Func<VerifiedPoint, Point2> at)
    {
        var feature = job.Features.First(f => f.Name == reference.Feature);
        var element = feature.Element(reference.Flank)
            ?? throw new ArgumentException($"Found {reference}, which is not straight; expected a line or a flank.", nameof(reference));
        return FeatureFits.Line(feature.Name, element.Method, [.. Select(element.Points, byLabel).Select(at)], 0);
    }

    private static VerifiedFeature Deviation(string name, bool alongX, IReadOnlyList<VerifiedPoint> points) => alongX
        ? new(
            name,
            VerifiedQuantity.DeviationX,
            0,
            points.Max(p => Math.Abs(p.BeforeError.Vector.X)),
            points.Max(p => Math.Abs(p.AfterError.Vector.X)))
        {
            Points = [.. points.Select(p => p.Label)]
        }
        : VerifiedFeature.DeviationOf(name, points);

    private static VerifiedFeature Of(string name, VerifiedQuantity quantity, Func<Func<VerifiedPoint, Point2>, double> value) =>
        new(name, quantity, value(p => p.Part), value(p => p.Before), value(p => p.After));

    private static VerifiedPoint[] Select(IReadOnlyList<string> labels, Dictionary<string, VerifiedPoint> byLabel) =>
        [.. labels.Select(l => byLabel[l])];
}
