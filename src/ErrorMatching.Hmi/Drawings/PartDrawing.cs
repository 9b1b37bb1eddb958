using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The features of a draft. Points are drawn at their coordinates; as long as none has any, features are drawn
/// schematically, one after another, by kind and number of points.</summary>
/// <param name="Lines">The features in the order of cutting.</param>
/// <param name="IsSchematic">True if positions are schematic.</param>
/// <param name="Known">Number of points with coordinates.</param>
/// <param name="Total">Number of points.</param>
internal sealed record PartDrawing(IReadOnlyList<PartLine> Lines, bool IsSchematic, int Known, int Total)
{
    private const double Step = 10, Depth = 12;

    /// <summary>The drawing of a draft.</summary>
    public static PartDrawing Of(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var known = draft.Features.Select(f => Line(
            f, [.. f.Flanks.Select(k => k.Select(p => (p.Label, Place(p, f.Plane))).ToArray())])).ToArray();
        var (count, total) = (known.Sum(l => l.Points.Count), draft.Features.Sum(f => f.Points.Count()));
        return count > 0 ? new(known, false, count, total) : new(Schematic(draft), true, 0, total);
    }

    // A point that has no place is left out; the outline of a kind takes all of them.
    private static PartLine Line(FeatureDraft feature, IReadOnlyList<(string Label, Point2? At)[]> flanks)
    {
        IReadOnlyList<Point2>[] places = [.. flanks.Select(k => k.Select(p => p.At).OfType<Point2>().ToArray())];
        return new(
            feature.Name,
            [.. flanks.SelectMany(k => k).Where(p => p.At is not null).Select(p => (p.Label, p.At!.Value))],
            flanks.All(k => k.All(p => p.At is not null)) ? feature.Kind.Outline(places) : [.. places.SelectMany(p => p)]);
    }

    private static Point2? Place(PointDraft point, string plane)
    {
        var (first, second) = plane switch { "ZX" => (point.Z, point.X), "YZ" => (point.Y, point.Z), _ => (point.X, point.Y) };
        return Number(first) is { } x && Number(second) is { } y ? new Point2(x, y) : null;
    }

    private static double? Number(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : null;

    private static List<PartLine> Schematic(MatingDraft draft)
    {
        var (lines, x) = (new List<PartLine>(), 0.0);
        foreach (var feature in draft.Features)
        {
            var (sketch, right) = (feature.Kind.Sketch([.. feature.Flanks.Select(k => k.Count)], Step, Depth), new Vector2(x, 0));
            lines.Add(new(
                feature.Name,
                [.. feature.Points.Zip(sketch.Points, (p, at) => (p.Label, at + right))],
                [.. sketch.Outline.Select(p => p + right)]));
            x += sketch.WidthMm;
        }

        return lines;
    }
}

/// <summary>A feature in the drawing of a part.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Points">Its points: labels, and positions in mm or schematic.</param>
/// <param name="Outline">The line through them. A triangle's line passes through its apex, which is not measured.</param>
internal sealed record PartLine(string Name, IReadOnlyList<(string Label, Point2 At)> Points, IReadOnlyList<Point2> Outline)
{
    /// <summary>The position at a share of its length from its first point.</summary>
    /// <param name="share">From 0 for the first point to 1 for the last one.</param>
    /// <exception cref="InvalidOperationException">There are no points.</exception>
    public Point2 At(double share)
    {
        if (Outline.Count == 0)
        {
            throw new InvalidOperationException("A line without points has no places.");
        }

        var left = share * Outline.Zip(Outline.Skip(1), (a, b) => a.DistanceTo(b)).Sum();
        for (var i = 1; i < Outline.Count; i++)
        {
            var (from, to) = (Outline[i - 1], Outline[i]);
            var length = from.DistanceTo(to);
            if (left <= length && length > 0)
            {
                return from.Lerp(to, left / length);
            }

            left -= length;
        }

        return Outline[^1];
    }
}
