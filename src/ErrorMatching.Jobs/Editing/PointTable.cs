using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Jobs;

/// <summary>Coordinates from a spreadsheet or a file: lines of cells with tabs, semicolons or commas between them, label and coordinates, or coordinates alone in the order of the draft's points.</summary>
public sealed partial class PointTable
{
    private readonly IReadOnlyList<PointDraft> _points;
    private readonly bool _hasLabels;

    private PointTable(IReadOnlyList<PointDraft> points, bool hasLabels, PointTableFault? fault) => (_points, _hasLabels, Fault) = (points, hasLabels, fault);

    /// <summary>How many points it has.</summary>
    public int Count => _points.Count;

    /// <summary>The first line that should hold coordinates and does not; null if there is none. Of a table with one nothing is taken: a point would keep what it had, and nobody would see it.</summary>
    public PointTableFault? Fault { get; }

    /// <summary>Reads a text. Headings, empty lines and lines that begin with # are left out; decimal commas become points where no comma separates.</summary>
    public static PointTable Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var separator = text.Contains('\t', StringComparison.Ordinal) ? '\t' : text.Contains(';', StringComparison.Ordinal) ? ';' : ',';
        var lines = text.Split('\n').Select((l, i) => (Number: i + 1, Text: l.Trim('\r', ' ').TrimEnd('\t'))).Where(l => l.Text.Trim(separator, ' ').Length > 0 && l.Text[0] != '#')
            .Select(l => (l.Number, l.Text, Cells: l.Text.Split(separator).Select(c => Cell(c, separator)).ToArray())).ToArray();

        // Three cells are a label and two coordinates: a label may be a number as well.
        var hasLabels = lines.Any(l => IsPoint(l.Cells) && l.Cells.Length > 2);
        var headings = lines.TakeWhile(l => IsHeading(l.Cells)).Count();
        var table = lines.Skip(headings).ToArray();
        if (table.FirstOrDefault(l => !IsPoint(l.Cells) || (l.Cells.Length > 2) != hasLabels) is { Text: not null } wrong)
        {
            return new([], false, new(wrong.Number, wrong.Text));
        }

        return new([.. table.Select(l => l.Cells).Select(r => hasLabels ? new PointDraft(r[0], r[1], r[2], r.Length > 3 ? r[3] : "") : new PointDraft("", r[0], r[1]))], hasLabels, null);
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

    /// <summary>What a table and a draft do not have in common, before the one is put into the other.</summary>
    /// <param name="draft">The draft.</param>
    /// <returns>The table's points that no point of a feature is named like, and the points of features that the table says nothing about, each in their order. Rows without labels are named by their number.</returns>
    public (IReadOnlyList<string> NotInFeatures, IReadOnlyList<string> NotInTable) Differences(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        string[] wanted = [.. draft.Features.SelectMany(f => f.Flanks).SelectMany(k => k).Select(p => p.Label.Trim())];
        if (IsWholeOf(draft))
        {
            return ([], []);
        }

        return _hasLabels
            ? ([.. _points.Select(p => p.Label).Except(wanted, StringComparer.Ordinal)], [.. wanted.Except(_points.Select(p => p.Label), StringComparer.Ordinal)])
            : ([.. Enumerable.Range(draft.Points.Count() + 1, Math.Max(0, _points.Count - draft.Points.Count())).Select(n => n.ToString(CultureInfo.InvariantCulture))], [.. wanted.Skip(_points.Count)]);
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

    private static bool IsPoint(string[] cells) => cells.Length is >= 2 and <= 4 && cells.Skip(cells.Length > 2 ? 1 : 0).All(IsNumber);

    // A point with one coordinate that cannot be read is none.
    private static bool IsHeading(string[] cells) => !IsPoint(cells) && (cells.Length < 3 || !(IsNumber(cells[^1]) || IsNumber(cells[^2])));

    private static string Cell(string cell, char separator)
    {
        var text = cell.Trim().Trim('"').Trim();
        return separator != ',' && DecimalComma().IsMatch(text) ? text.Replace(',', '.') : text;
    }

    private static bool IsNumber(string text) => DraftNumber.Json(text) is { } json && double.Parse(json, CultureInfo.InvariantCulture) is var value && double.IsFinite(value);

    [GeneratedRegex(@"^[-+\u2212]?[0-9]*,[0-9]+$", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex DecimalComma();
}
