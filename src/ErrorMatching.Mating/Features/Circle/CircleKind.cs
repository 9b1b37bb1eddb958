using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Bores and bosses: whole circles, or the larger part of one.</summary>
internal sealed class CircleKind : FeatureKind
{
    internal const string CenterX = "centerXMm", CenterY = "centerYMm", Diameter = "diameterMm", Roundness = "roundnessMm";

    internal static readonly VerifiedQuantity ComparedDiameter = new("diameter", "diameter", "mm");

    private const string Inscribed = "inscribed", Circumscribed = "circumscribed";

    // Number of pieces that make a whole circle look round.
    private const int Pieces = 72;

    private CircleKind()
    {
    }

    /// <summary>The kind.</summary>
    public static CircleKind Instance { get; } = new();

    /// <inheritdoc/>
    public override string Word => "circle";

    /// <inheritdoc/>
    public override string Letter => "B";

    /// <inheritdoc/>
    public override IReadOnlyList<int> LeastPoints { get; } = [3];

    /// <inheritdoc/>
    public override bool IsStraight => false;

    /// <inheritdoc/>
    public override IReadOnlyList<FeatureKey> Keys { get; } = [new("method", ["least-squares", Inscribed, Circumscribed])];

    /// <inheritdoc/>
    public override IReadOnlyDictionary<string, string> Quantities { get; } = new Dictionary<string, string>
    {
        [CenterX] = "center, X",
        [CenterY] = "center, Y",
        [Diameter] = "diameter",
        [Roundness] = "roundness",
    };

    /// <inheritdoc/>
    public override IReadOnlyList<VerifiedQuantity> Verified { get; } = [ComparedDiameter];

    internal override string? ElementWords => null;

    /// <inheritdoc/>
    public override IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists)
    {
        ArgumentNullException.ThrowIfNull(lists);
        try
        {
            return Around(CircleFit.Fit(lists[0]).Circle);
        }
        catch (GeometryException)
        {
            // Points that are still being entered need not be on a circle.
            return lists[0];
        }
    }

    /// <inheritdoc/>
    public override FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height)
    {
        ArgumentNullException.ThrowIfNull(counts);

        // Large enough for its points, one step apart.
        var radius = Math.Max(height, step * counts[0] / (2 * Math.PI));
        var circle = new Circle2(new(radius, 0), radius);
        Point2[] points = [.. Enumerable.Range(0, counts[0]).Select(i => circle.At(Angle.FromDegrees(180 - (360.0 * i / counts[0]))))];
        return new(points, Around(circle), (2 * radius) + step);
    }

    internal override JobFeature Read(FeatureReading reading) => new CircleFeature(
        reading.Name,
        reading.Blocks,
        reading.Tolerance,
        reading.Plane,
        reading.Points(this)[0],
        reading.Item.Find("method")?.Text switch
        {
            Inscribed => CircleMethod.Inscribed,
            Circumscribed => CircleMethod.Circumscribed,
            _ => CircleMethod.LeastSquares,
        });

    internal override FoundPass? WholeOf(NcPath path, FoundPass cut, int motion)
    {
        if (!path.Motions[motion].IsArc)
        {
            return null;
        }

        var (first, last) = (motion, motion);
        for (var m = motion - 1; m >= cut.First && BelongsTo(path, motion, m); m--)
        {
            first = path.Motions[m].MovesInPlane ? m : first;
        }

        for (var m = motion + 1; m <= cut.Last && BelongsTo(path, motion, m); m++)
        {
            last = path.Motions[m].MovesInPlane ? m : last;
        }

        return new(first, last);
    }

    /// <summary>True if a motion is on the circle of an arc and in the same direction, or has no length.</summary>
    internal static bool BelongsTo(NcPath path, int arc, int motion)
    {
        const double Same = 0.01;
        var (a, m) = (path.Motions[arc], path.Motions[motion]);
        return !m.MovesInPlane
            || (m.Kind == a.Kind && m.Center.DistanceTo(a.Center) <= Same && Math.Abs(m.Arc.Radius - a.Arc.Radius) <= Same);
    }

    /// <summary>A circle as a closed polyline.</summary>
    private static Point2[] Around(Circle2 circle) =>
        [.. Enumerable.Range(0, Pieces + 1).Select(i => circle.At(Angle.FromDegrees(360.0 * i / Pieces)))];
}
