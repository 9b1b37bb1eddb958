using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Slots and keys: two parallel flanks with round ends.</summary>
internal sealed class SlotKind : FeatureKind
{
    internal const string Width = "widthMm", Length = "lengthMm", CenterX = "centerXMm", CenterY = "centerYMm";

    internal static readonly VerifiedQuantity ComparedWidth = new("width", "width", "mm");

    /// <summary>Number of pieces that make a round end look round.</summary>
    internal const int Pieces = 24;

    // A contour of more motions is not a slot.
    private const int MostMotions = 64;

    private const double SamePlaceMm = 1e-6;

    private SlotKind()
    {
    }

    /// <summary>The kind.</summary>
    public static SlotKind Instance { get; } = new();

    /// <inheritdoc/>
    public override string Word => "slot";

    /// <inheritdoc/>
    public override string Letter => "S";

    /// <inheritdoc/>
    public override IReadOnlyList<int> LeastPoints { get; } = [2, 1, 2, 1];

    /// <inheritdoc/>
    public override bool IsStraight => false;

    /// <inheritdoc/>
    public override IReadOnlyList<FeatureKey> Keys { get; } = [];

    /// <inheritdoc/>
    public override IReadOnlyDictionary<string, string> Quantities { get; } = new Dictionary<string, string>
    {
        [Width] = "width",
        [Length] = "length",
        [CenterX] = "center, X",
        [CenterY] = "center, Y",
        [FeatureQuantity.Direction] = "direction",
    };

    /// <inheritdoc/>
    public override IReadOnlyList<VerifiedQuantity> Verified { get; } = [ComparedWidth, VerifiedQuantity.Length];

    internal override string ElementWords => "of a slot with /1 or /2 for its flank";

    /// <inheritdoc/>
    public override IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists)
    {
        ArgumentNullException.ThrowIfNull(lists);
        try
        {
            return lists.All(l => l.Count > 0) ? MeasuredSlot.Fit(lists, 0).Outline(Pieces) : [.. lists.SelectMany(l => l)];
        }
        catch (GeometryException)
        {
            // Points that are still being entered need not be on a slot.
            return [.. lists.SelectMany(l => l)];
        }
    }

    /// <inheritdoc/>
    public override FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height)
    {
        ArgumentNullException.ThrowIfNull(counts);

        // As long as the flank with more points needs, with ends as high as other features.
        var (radius, length) = (height / 2, step * (Math.Max(counts[0], counts[2]) + 1));
        var (left, right) = (new Point2(radius, 0), new Point2(radius + length, 0));
        IReadOnlyList<Point2>[] lists =
        [
            [.. Enumerable.Range(1, counts[0]).Select(i => new Point2(radius + (length * i / (counts[0] + 1)), -radius))],
            [
                .. Enumerable.Range(1, counts[1]).Select(
                    i => new Circle2(right, radius).At(Angle.FromDegrees(-90 + (180.0 * i / (counts[1] + 1)))))],
            [.. Enumerable.Range(1, counts[2]).Select(i => new Point2(radius + length - (length * i / (counts[2] + 1)), radius))],
            [
                .. Enumerable.Range(1, counts[3]).Select(
                    i => new Circle2(left, radius).At(Angle.FromDegrees(90 + (180.0 * i / (counts[3] + 1)))))],
        ];
        return new([.. lists.SelectMany(l => l)], Outline(lists), length + (2 * radius) + step);
    }

    internal override JobFeature Read(FeatureReading reading) =>
        new SlotFeature(reading.Name, reading.Blocks, reading.Tolerance, reading.Plane, [.. reading.Points(this)]);

    internal override FoundPass? WholeOf(NcPath path, FoundPass cut, int motion)
    {
        // The smallest closed contour that the motion belongs to.
        for (var span = 2; span < MostMotions; span++)
        {
            for (var first = Math.Max(cut.First, motion - span + 1); first <= motion && first + span - 1 <= cut.Last; first++)
            {
                if (path.Motions[first].PlaneStart.DistanceTo(path.Motions[first + span - 1].PlaneEnd) < SamePlaceMm
                    && path.Motions[first].MovesInPlane)
                {
                    return new(first, first + span - 1);
                }
            }
        }

        return null;
    }
}
