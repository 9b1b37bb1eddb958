using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Notches and ridges of two straight flanks.</summary>
public sealed class TriangleKind : FeatureKind
{
    internal const string ApexX = "apexXMm", ApexY = "apexYMm", IncludedAngle = "angleDeg", FirstFlank = "firstFlankMm",
        SecondFlank = "secondFlankMm";

    private TriangleKind()
    {
    }

    /// <summary>The kind.</summary>
    public static TriangleKind Instance { get; } = new();

    /// <inheritdoc/>
    public override string Word => "triangle";

    /// <inheritdoc/>
    public override string Letter => "T";

    /// <inheritdoc/>
    public override IReadOnlyList<int> LeastPoints { get; } = [2, 2];

    /// <inheritdoc/>
    public override bool IsStraight => true;

    /// <inheritdoc/>
    public override IReadOnlyList<FeatureKey> Keys { get; } = [];

    /// <inheritdoc/>
    public override IReadOnlyDictionary<string, string> Quantities { get; } = new Dictionary<string, string>
    {
        [ApexX] = "apex, X",
        [ApexY] = "apex, Y",
        [IncludedAngle] = "included angle",
        [FirstFlank] = "first flank",
        [SecondFlank] = "second flank",
    };

    /// <inheritdoc/>
    public override IReadOnlyList<VerifiedQuantity> Verified { get; } = [VerifiedQuantity.Angle];

    internal override string ElementWords => "of a triangle with /1 or /2 for its flank";

    /// <inheritdoc/>
    public override IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists)
    {
        ArgumentNullException.ThrowIfNull(lists);
        return ApexOf(lists[0], lists[1]) is { } apex ? [.. lists[0], apex, .. lists[1]] : [.. lists[0], .. lists[1]];
    }

    /// <inheritdoc/>
    public override FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height)
    {
        ArgumentNullException.ThrowIfNull(counts);
        var (first, all) = (counts[0], counts[0] + counts[1]);

        // Straight down to the apex, which is half a step from the last point of either flank.
        Point2[] points = [
            .. Enumerable.Range(0, all).Select(i => new Point2(
                step * i, i < first ? -height * (i + 1) / (first + 0.5) : -height * (all - i) / (counts[1] + 0.5)))];
        return new(points, Outline([points[..first], points[first..]]), step * (all + 0.5));
    }

    internal override JobFeature Read(FeatureReading reading)
    {
        var flanks = reading.Points(this);
        return new TriangleFeature(reading.Name, reading.Blocks, reading.Tolerance, reading.Plane, flanks[0], flanks[1]);
    }

    // Null if no apex lies between the flanks: they are parallel, or their points do not lead to it.
    private static Point2? ApexOf(IReadOnlyList<Point2> first, IReadOnlyList<Point2> second)
    {
        if (first.Count < 2 || second.Count < 2)
        {
            return null;
        }

        try
        {
            var apex = Wedge.Fit(first, second).Apex;
            return (apex - first[^1]).Dot(first[^1] - first[0]) > 0 && (apex - second[0]).Dot(second[0] - second[^1]) > 0 ? apex : null;
        }
        catch (GeometryException)
        {
            return null;
        }
    }
}
