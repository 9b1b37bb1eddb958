using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>The features of a draft. Points are drawn at their coordinates; as long as none has any, features are drawn
/// schematically, one after another, by kind and number of points.</summary>
/// <param name="Lines">The features in the order of cutting.</param>
/// <param name="IsSchematic">True if positions are schematic.</param>
/// <param name="Known">Number of points with coordinates.</param>
/// <param name="Total">Number of points.</param>
public sealed record PartDrawing(IReadOnlyList<PartLine> Lines, bool IsSchematic, int Known, int Total)
{
    private const double Step = 10, Depth = 12;

    // With this many segments between two points, a curve looks smooth.
    private const int Pieces = 8;

    /// <summary>The drawing of a draft.</summary>
    public static PartDrawing Of(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var known = draft.Features.Select(f => Line(f.Name, [.. f.Flanks.Select(k => k.Select(p => (p.Label, Place(p, f.Plane))).ToArray())])).ToArray();
        var (count, total) = (known.Sum(l => l.Points.Count), draft.Features.Sum(f => f.Points.Count()));
        return count > 0 ? new(known, false, count, total) : new(Schematic(draft), true, 0, total);
    }

    // Points without a position are left out.
    private static PartLine Line(string name, IReadOnlyList<(string Label, Point2? At)[]> flanks)
    {
        Point2[][] places = [.. flanks.Select(k => k.Select(p => p.At).OfType<Point2>().ToArray())];
        return new(name, [.. flanks.SelectMany(k => k).Where(p => p.At is not null).Select(p => (p.Label, p.At!.Value))], places.Length == 2 && flanks.All(k => k.All(p => p.At is not null)) && ApexOf(places[0], places[1]) is { } apex
            ? [.. places[0], apex, .. places[1]]
            : [.. places.SelectMany(p => p)]);
    }

    // Null if the flanks have no apex between them, because they are parallel or do not lead there.
    private static Point2? ApexOf(Point2[] first, Point2[] second)
    {
        if (first.Length < 2 || second.Length < 2)
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

    private static Point2? Place(PointDraft point, string plane)
    {
        var (first, second) = plane switch { "ZX" => (point.Z, point.X), "YZ" => (point.Y, point.Z), _ => (point.X, point.Y) };
        return Number(first) is { } x && Number(second) is { } y ? new Point2(x, y) : null;
    }

    private static double? Number(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : null;

    private static List<PartLine> Schematic(MatingDraft draft)
    {
        var (lines, x) = (new List<PartLine>(), 0.0);
        foreach (var feature in draft.Features)
        {
            var (first, from) = (feature.Flanks[0].Count, x);
            var line = Line(feature.Name, [.. feature.Flanks.Select((k, flank) => k.Select((p, i) => (p.Label, (Point2?)At((flank == 0 ? 0 : first) + i))).ToArray())]);

            // Three points of a curve also form a curve; with straight lines they would be two sides of a triangle.
            lines.Add(feature.Kind == FeatureKind.Curve && first > 1 ? line with { Outline = [.. Enumerable.Range(0, ((first - 1) * Pieces) + 1).Select(i => At((double)i / Pieces))] } : line);
            x += Step * (feature.Points.Count() + 0.5);

            Point2 At(double i) => new(from + (Step * i), Height(i));

            double Height(double i) => feature.Kind switch
            {
                FeatureKind.Line => 0,
                // Straight down to the apex, which is half a step from the last point of either flank.
                FeatureKind.Triangle when i < first => -Depth * (i + 1) / (first + 0.5),
                FeatureKind.Triangle => -Depth * (feature.Points.Count() - i) / (feature.Flanks[1].Count + 0.5),
                _ => Depth * Math.Sin(Math.PI * i / Math.Max(1, first - 1)),
            };
        }

        return lines;
    }
}
