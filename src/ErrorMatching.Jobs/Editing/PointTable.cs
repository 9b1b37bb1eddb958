using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Jobs;

/// <summary>Coordinates from a spreadsheet or a file: lines of cells with tabs, semicolons or commas between them, label and coordinates, or coordinates alone in the order of the draft's points.</summary>
public sealed partial class PointTable
{
    private readonly IReadOnlyList<PointDraft> _points;
    private readonly bool _hasLabels;

    private PointTable(IReadOnlyList<PointDraft> points, bool hasLabels) => (_points, _hasLabels) = (points, hasLabels);

    /// <summary>How many points it has.</summary>
    public int Count => _points.Count;

    /// <summary>Reads a text. Lines that hold no coordinates, such as a heading, are left out; decimal commas become points where no comma separates.</summary>
    public static PointTable Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var separator = text.Contains('\t', StringComparison.Ordinal) ? '\t' : text.Contains(';', StringComparison.Ordinal) ? ';' : ',';
        var rows = text.Split('\n').Select(l => l.Trim('\r', ' ').TrimEnd('\t').Split(separator).Select(c => Cell(c, separator)).ToArray())
            .Where(r => r.Length is >= 2 and <= 4 && IsNumber(r[^1]) && IsNumber(r[^2])).ToArray();

        // Three cells are a label and two coordinates: a label may be a number as well.
        var hasLabels = rows.Any(r => r.Length > 2);
        return new([.. rows.Where(r => r.Length > 2 == hasLabels).Select(r => hasLabels ? new PointDraft(r[0], r[1], r[2], r.Length > 3 ? r[3] : "") : new PointDraft("", r[0], r[1]))], hasLabels);
    }

    /// <summary>
    /// The draft with these coordinates: by their labels, points that it has not become points of no feature; or without labels in the order of its points. Where it has as many points, none of them with a coordinate yet,
    /// and other labels, its points become those of the table in its order.
    /// </summary>
    public MatingDraft Into(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        return IsWholeOf(draft) ? With(draft, Labeled) : Filled(draft);
    }

    // Labels that a count of points gave are nobody's choice yet.
    private bool IsWholeOf(MatingDraft draft)
    {
        var points = draft.Points.ToArray();
        var labels = _points.Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        return _hasLabels && points.Length == _points.Count && labels.Count == _points.Count && points.All(p => p.X.Length + p.Y.Length + p.Z.Length == 0) && !labels.SetEquals(points.Select(p => p.Label.Trim()));
    }

    private static MatingDraft With(MatingDraft draft, Func<int, PointDraft, PointDraft> point)
    {
        var next = 0;
        return draft with { Features = [.. draft.Features.Select(f => f with { Flanks = [.. f.Flanks.Select(k => (IReadOnlyList<PointDraft>)[.. k.Select(p => point(next++, p))])] })], OtherPoints = [.. draft.OtherPoints.Select(p => point(next++, p))] };
    }

    private PointDraft Labeled(int index, PointDraft was) => _points[index];

    private MatingDraft Filled(MatingDraft draft)
    {
        var byLabel = _points.GroupBy(p => p.Label, StringComparer.Ordinal).ToDictionary(g => g.Key, g => g.Last(), StringComparer.Ordinal);
        var filled = With(draft, (index, point) => (_hasLabels ? byLabel.GetValueOrDefault(point.Label.Trim()) : index < _points.Count ? _points[index] : null) is { } found
            ? point with { X = found.X, Y = found.Y, Z = found.Z.Length > 0 ? found.Z : point.Z }
            : point);
        var known = draft.Points.Select(p => p.Label.Trim()).ToHashSet(StringComparer.Ordinal);
        return _hasLabels ? filled with { OtherPoints = [.. filled.OtherPoints, .. byLabel.Values.Where(p => !known.Contains(p.Label))] } : filled;
    }

    private static string Cell(string cell, char separator)
    {
        var text = cell.Trim().Trim('"').Trim();
        return separator != ',' && DecimalComma().IsMatch(text) ? text.Replace(',', '.') : text;
    }

    private static bool IsNumber(string text) => DraftNumber.Json(text) is { } json && double.Parse(json, CultureInfo.InvariantCulture) is var value && double.IsFinite(value);

    [GeneratedRegex(@"^[-+\u2212]?[0-9]*,[0-9]+$", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex DecimalComma();
}
