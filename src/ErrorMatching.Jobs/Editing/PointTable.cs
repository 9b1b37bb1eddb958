using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Jobs;

/// <summary>Coordinates from a spreadsheet or a file: lines of cells separated by tabs, semicolons or commas, with label and coordinates,
/// or coordinates alone in the order of the draft's points.</summary>
public sealed partial class PointTable
{
    private readonly IReadOnlyList<PointDraft> _points;
    private readonly bool _hasLabels;

    private PointTable(IReadOnlyList<PointDraft> points, bool hasLabels, PointTableFault? fault) =>
        (_points, _hasLabels, Fault) = (points, hasLabels, fault);

    /// <summary>Number of points.</summary>
    public int Count => _points.Count;

    /// <summary>The first line that should contain coordinates and does not, or null. Nothing is taken from a table with a fault, because
    /// a point would silently keep its old values.</summary>
    public PointTableFault? Fault { get; }

    /// <summary>Reads a text. Skips headings, empty lines and lines that begin with #; reads decimal commas unless commas separate
    /// cells.</summary>
    public static PointTable Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var separator = text.Contains('\t', StringComparison.Ordinal) ? '\t' : text.Contains(';', StringComparison.Ordinal) ? ';' : ',';
        var lines = text.Split('\n')
            .Select((l, i) => (Number: i + 1, Text: l.Trim('\r', ' ').TrimEnd('\t')))
            .Where(l => l.Text.Trim(separator, ' ').Length > 0 && l.Text[0] != '#')
            .Select(l => (l.Number, l.Text, Cells: l.Text.Split(separator).Select(c => Cell(c, separator)).ToArray())).ToArray();

        // Three cells are a label and two coordinates; the label may be a number too.
        var hasLabels = lines.Any(l => IsPoint(l.Cells) && l.Cells.Length > 2);
        var headings = lines.TakeWhile(l => IsHeading(l.Cells)).Count();
        var table = lines.Skip(headings).ToArray();
        if (table.FirstOrDefault(l => !IsPoint(l.Cells) || (l.Cells.Length > 2) != hasLabels) is { Text: not null } wrong)
        {
            return new([], false, new(wrong.Number, wrong.Text));
        }

        return new(
            [
                .. table.Select(l => l.Cells).Select(
                    r => hasLabels ? new PointDraft(r[0], r[1], r[2], r.Length > 3 ? r[3] : "") : new PointDraft("", r[0], r[1]))],
            hasLabels,
            null);
    }

    /// <summary>Puts the coordinates into a draft: by label, or without labels in the order of its points. Automatically numbered labels
    /// were chosen by no one. As long as their points have no coordinates, they take the rows that no other point uses: by label if all
    /// labels are the same; otherwise in the table's order, with its labels, if the counts match. If the assignment of rows is ambiguous,
    /// nothing is taken.</summary>
    /// <param name="draft">The draft.</param>
    /// <returns>The draft with the coordinates, or why it is unchanged. Rows with unknown labels become points without a
    /// feature.</returns>
    public TakenTable Into(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        return !draft.Features.SelectMany(f => f.Points).Any()
            ? new(draft, PointTableRefusal.NoFeatures)
            : _hasLabels
            ? ByLabel(draft)
            : ByOrder(draft);
    }

    private TakenTable ByOrder(MatingDraft draft)
    {
        var (all, ofFeatures) = (draft.Points.Count(), draft.Features.Sum(f => f.Points.Count()));
        return _points.Count == ofFeatures || _points.Count == all
            ? new(draft.WithRows((index, _) => _points.ElementAtOrDefault(index)))
            : new(draft, PointTableRefusal.NoLabels) { Rows = _points.Count, Points = all };
    }

    private TakenTable ByLabel(MatingDraft draft)
    {
        var byLabel = _points.ToLookup(p => p.Label, StringComparer.Ordinal);
        if (byLabel.Where(l => l.Count() > 1).Select(l => l.Key).ToArray() is { Length: > 0 } twice)
        {
            return new(draft, PointTableRefusal.LabelTwice) { OnlyInTable = twice };
        }

        var ofFeatures = draft.Features.SelectMany(f => f.Points).ToArray();
        string[] waiting = [.. ofFeatures.Where(IsWaiting).Select(LabelOf)];
        var chosen = ofFeatures.Where(p => !IsWaiting(p)).Concat(draft.OtherPoints).Select(LabelOf).ToHashSet(StringComparer.Ordinal);
        var left = _points.Where(p => !chosen.Contains(p.Label)).ToArray();
        var leftLabels = left.Select(p => p.Label).ToHashSet(StringComparer.Ordinal);

        // The user has named a point and so has seen the labels; surplus rows are points without a feature.
        var isByLabel = waiting.Length == 0
            || left.Length == 0
            || leftLabels.SetEquals(waiting)
            || (ofFeatures.Any(IsNamed) && leftLabels.IsSupersetOf(waiting));
        var onlyInTable = left.Where(p => !draft.Points.Select(LabelOf).Contains(p.Label, StringComparer.Ordinal)).ToArray();
        if (!isByLabel && left.Length != waiting.Length)
        {
            return Taken(draft) with
            {
                Refusal = PointTableRefusal.OtherCount,
                OnlyInTable = [.. onlyInTable.Select(p => p.Label)],
                Rows = left.Length,
                Points = waiting.Length
            };
        }

        var next = 0;
        var filled = draft.WithRows(
            (index, point) => index >= ofFeatures.Length || !IsWaiting(point) ? byLabel[LabelOf(point)].FirstOrDefault()
            : isByLabel ? Array.Find(left, p => p.Label == LabelOf(point)) : left[next++]);
        return isByLabel
            ? Taken(filled with { OtherPoints = [.. filled.OtherPoints, .. onlyInTable] }) with
            {
                OnlyInTable = [.. onlyInTable.Select(p => p.Label)]
            }
            : Taken(filled) with { HasNewLabels = true };

        TakenTable Taken(MatingDraft now) =>
            new(now) { OnlyInFeatures = [.. now.Features.SelectMany(f => f.Points).Select(LabelOf).Where(l => !byLabel.Contains(l))] };
    }

    private static string LabelOf(PointDraft point) => point.Label.Trim();

    private static bool IsNamed(PointDraft point) => !LabelOf(point).All(char.IsAsciiDigit);

    // The point needs a label and coordinates.
    private static bool IsWaiting(PointDraft point) => !IsNamed(point) && point.X.Length + point.Y.Length + point.Z.Length == 0;

    // In a table with a label column, each point has a label.
    private static bool IsPoint(string[] cells) =>
        cells.Length is >= 2 and <= 4 && (cells.Length == 2 || cells[0].Length > 0) && cells.Skip(cells.Length > 2 ? 1 : 0).All(IsNumber);

    // A point with one unreadable coordinate is not a heading.
    private static bool IsHeading(string[] cells) => !IsPoint(cells) && (cells.Length < 3 || !(IsNumber(cells[^1]) || IsNumber(cells[^2])));

    private static string Cell(string cell, char separator)
    {
        var text = cell.Trim().Trim('"').Trim();
        return separator != ',' && DecimalComma().IsMatch(text) ? text.Replace(',', '.') : text;
    }

    private static bool IsNumber(string text) =>
        DraftNumber.Json(text) is { } json && double.Parse(json, CultureInfo.InvariantCulture) is var value && double.IsFinite(value);

    [GeneratedRegex(@"^[-+\u2212]?[0-9]*,[0-9]+$", RegexOptions.CultureInvariant, Timeout.Infinite)]
    private static partial Regex DecimalComma();
}

/// <summary>A line of a <see cref="PointTable"/> that should contain coordinates and does not.</summary>
/// <param name="Line">Its number, from 1.</param>
/// <param name="Text">Its text.</param>
public sealed record PointTableFault(int Line, string Text);

/// <summary>The result of putting a <see cref="PointTable"/> into a draft.</summary>
/// <param name="Draft">The draft with the coordinates; unchanged if refused.</param>
/// <param name="Refusal">Why nothing was taken, if refused.</param>
public sealed record TakenTable(MatingDraft Draft, PointTableRefusal Refusal = PointTableRefusal.None)
{
    /// <summary>True if points took their labels from the table, in its order.</summary>
    public bool HasNewLabels { get; init; }

    /// <summary>The table's labels without a point, in its order; the duplicate labels for
    /// <see cref="PointTableRefusal.LabelTwice"/>.</summary>
    public IReadOnlyList<string> OnlyInTable { get; init; } = [];

    /// <summary>Labels of the features' points that are not in the table, in their order.</summary>
    public IReadOnlyList<string> OnlyInFeatures { get; init; } = [];

    /// <summary>Number of rows left for the points, if the numbers differ.</summary>
    public int Rows { get; init; }

    /// <summary>Number of those points.</summary>
    public int Points { get; init; }
}

/// <summary>Why nothing from a <see cref="PointTable"/> was put into a draft.</summary>
public enum PointTableRefusal
{
    /// <summary>Not refused; the coordinates were taken.</summary>
    None,

    /// <summary>The features have no points yet to take coordinates.</summary>
    NoFeatures,

    /// <summary>The table has a duplicate label.</summary>
    LabelTwice,

    /// <summary>The number of points waiting for labels and the number of unused rows differ, so rows cannot be assigned.</summary>
    OtherCount,

    /// <summary>The number of rows without labels differs from the number of points.</summary>
    NoLabels,
}
