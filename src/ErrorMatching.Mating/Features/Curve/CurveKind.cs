using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Hills and valleys.</summary>
public sealed class CurveKind : FeatureKind
{
    internal const string Chord = "chordMm", ArcLength = "arcLengthMm";
    private const string Degree = "degree", Ridge = "ridge";

    // Number of pieces between two points that make a curve look round.
    private const int Pieces = 8;

    private CurveKind()
    {
    }

    /// <summary>The kind.</summary>
    public static CurveKind Instance { get; } = new();

    /// <inheritdoc/>
    public override string Word => "curve";

    /// <inheritdoc/>
    public override string Letter => "C";

    /// <inheritdoc/>
    public override IReadOnlyList<int> LeastPoints { get; } = [3];

    /// <inheritdoc/>
    public override bool IsStraight => false;

    /// <inheritdoc/>
    public override IReadOnlyList<FeatureKey> Keys { get; } = [new(Degree, []), new(Ridge, [])];

    /// <inheritdoc/>
    public override IReadOnlyDictionary<string, string> Quantities { get; } = new Dictionary<string, string>
    {
        [Chord] = "chord",
        [ArcLength] = "length along the curve",
    };

    /// <inheritdoc/>
    public override IReadOnlyList<VerifiedQuantity> Verified { get; } = [];

    internal override string? ElementWords => null;

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
        var count = counts[0];
        Point2[] points = [.. Enumerable.Range(0, count).Select(i => At(i))];
        return new(
            points,
            count > 1 ? [.. Enumerable.Range(0, ((count - 1) * Pieces) + 1).Select(i => At((double)i / Pieces))] : points,
            step * (count + 0.5));

        Point2 At(double i) => new(step * i, height * Elementary.Sin(Math.PI * i / Math.Max(1, count - 1)));
    }

    internal override JobFeature Read(FeatureReading reading)
    {
        var points = reading.Points(this)[0];
        int? degree = reading.Number(Degree) is { } d ? (int)Math.Min(d, int.MaxValue) : null;
        if (degree >= points.Count && points.Count >= LeastPoints[0])
        {
            var expected = string.Create(CultureInfo.InvariantCulture, $"at most {points.Count - 1} for {points.Count} points");
            reading.Refuse(Degree, "degree-too-high", $"the degree {reading.Item[Degree].Text}", expected);
        }

        return new CurveFeature(reading.Name, reading.Blocks, reading.Tolerance, reading.Plane, points, degree, reading.Number(Ridge));
    }
}
