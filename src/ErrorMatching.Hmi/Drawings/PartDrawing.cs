using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A part as far as its draft says: points with coordinates where they are, and while none has any, features one after another by kind and number of points.</summary>
/// <param name="Lines">Its features in the order of cutting.</param>
/// <param name="IsSchematic">True if places mean nothing.</param>
/// <param name="Known">How many points have coordinates.</param>
/// <param name="Total">How many points there are.</param>
public sealed record PartDrawing(IReadOnlyList<PartLine> Lines, bool IsSchematic, int Known, int Total)
{
    private const double Step = 10, Depth = 12;

    /// <summary>The drawing of a draft.</summary>
    public static PartDrawing Of(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var known = draft.Features.Select(f => new PartLine(f.Name, [.. f.Points.Select(p => (p.Label, At: Place(p, f.Plane))).Where(p => p.At is not null).Select(p => (p.Label, p.At!.Value))])).ToArray();
        var (count, total) = (known.Sum(l => l.Points.Count), draft.Features.Sum(f => f.Points.Count()));
        return count > 0 ? new(known, false, count, total) : new(Schematic(draft), true, 0, total);
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
            lines.Add(new(feature.Name, [.. feature.Points.Select((p, i) => (p.Label, new Point2(from + (Step * i), Height(i))))]));
            x += Step * (feature.Points.Count() + 0.5);

            double Height(int i) => feature.Kind switch
            {
                FeatureKind.Line => 0,
                FeatureKind.Triangle when i < first => -Depth * (i + 1) / first,
                FeatureKind.Triangle => -Depth * (feature.Points.Count() - i) / Math.Max(1, feature.Flanks[1].Count),
                _ => Depth * Math.Sin(Math.PI * i / Math.Max(1, first - 1)),
            };
        }

        return lines;
    }
}
