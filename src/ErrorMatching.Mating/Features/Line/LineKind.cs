using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Straight lines.</summary>
public sealed class LineKind : FeatureKind
{
    internal const string Length = "lengthMm";
    private const string Total = "tls", Ordinary = "ols";

    private LineKind()
    {
    }

    /// <summary>The kind.</summary>
    public static LineKind Instance { get; } = new();

    /// <inheritdoc/>
    public override string Word => "line";

    /// <inheritdoc/>
    public override string Letter => "L";

    /// <inheritdoc/>
    public override IReadOnlyList<int> LeastPoints { get; } = [2];

    /// <inheritdoc/>
    public override bool IsStraight => true;

    /// <inheritdoc/>
    public override IReadOnlyList<FeatureKey> Keys { get; } = [new("method", [Total, Ordinary])];

    /// <inheritdoc/>
    public override IReadOnlyDictionary<string, string> Quantities { get; } = new Dictionary<string, string>
    {
        [Length] = "length",
        [FeatureQuantity.Direction] = "direction",
    };

    /// <inheritdoc/>
    public override IReadOnlyList<VerifiedQuantity> Verified { get; } = [VerifiedQuantity.Length];

    internal override string ElementWords => "of a line";

    /// <inheritdoc/>
    public override IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists)
    {
        ArgumentNullException.ThrowIfNull(lists);
        return lists[0];
    }

    /// <inheritdoc/>
    public override FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height)
    {
        ArgumentNullException.ThrowIfNull(counts);
        Point2[] points = [.. Enumerable.Range(0, counts[0]).Select(i => new Point2(step * i, 0))];
        return new(points, points, step * (counts[0] + 0.5));
    }

    internal override JobFeature Read(FeatureReading reading) => new LineFeature(
        reading.Name,
        reading.Blocks,
        reading.Tolerance,
        reading.Plane,
        reading.Points(this)[0],
        reading.Item.Find("method")?.Text == Ordinary ? LineMethod.Ordinary : LineMethod.Total);
}
