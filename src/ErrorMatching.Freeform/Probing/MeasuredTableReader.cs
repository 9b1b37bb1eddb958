using System.Buffers;
using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads a table with one line per point: header columns point, or i and j, and x, y, z. Others are ignored.</summary>
internal sealed class MeasuredTableReader(string file, bool isCenter)
{
    private static readonly SearchValues<char> OfNumbers = SearchValues.Create("-+.0123456789");

    private char _delimiter;

    public IReadOnlyList<RawPoint> Read(IReadOnlyList<string> lines)
    {
        var head = 0;
        while (lines[head].Trim().Length == 0)
        {
            head++;
        }

        _delimiter = DelimiterOf(lines[head]);
        var names = lines[head].Split(_delimiter).Select(n => n.Trim().Trim('"').ToLowerInvariant()).ToArray();
        var (x, y, z) = (Column("x", "x_mm"), Column("y", "y_mm"), Column("z", "z_mm"));
        var (point, i, j) = (Find("point", "label"), Find("i"), Find("j"));
        if (point < 0 && (i < 0 || j < 0))
        {
            throw InputException.At(
                "missing-column",
                file,
                $"found a header with the columns {string.Join(", ", names.Take(20).Select(ProbingLogReader.Shown))}; expected point, or "
                    + $"i and j.",
                head + 1);
        }

        var points = new List<RawPoint>();
        for (var row = head + 1; row < lines.Count; row++)
        {
            if (lines[row].Trim().Length == 0)
            {
                continue;
            }

            var cells = lines[row].Split(_delimiter);
            if (cells.Length < names.Length)
            {
                throw InputException.At(
                    "short-row",
                    file,
                    FormattableString.Invariant($"found a line of {cells.Length} cells; expected {names.Length} as in the header."),
                    row + 1);
            }

            // A decimal comma would split a coordinate into two and give a different point.
            if (cells.Skip(names.Length).Any(c => c.Trim().Length > 0))
            {
                throw InputException.At(
                    "long-row",
                    file,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"found a line of {cells.Length} cells; expected {names.Length} as in the header, and numbers with a decimal "
                            + $"point."),
                    row + 1);
            }

            var position = new Point3(Number(cells, x, row), Number(cells, y, row), Number(cells, z, row));
            points.Add(point >= 0
                ? new(
                    Label(cells[point].Trim().Trim('"'), row, point),
                    i >= 0 && j >= 0 ? Whole(cells, i, row) : null,
                    i >= 0 && j >= 0 ? Whole(cells, j, row) : null,
                    position,
                    isCenter,
                    row + 1)
                : new(null, Whole(cells, i, row), Whole(cells, j, row), position, isCenter, row + 1));
        }

        return points;

        int Find(params string[] any) => Array.FindIndex(names, n => any.Contains(n, StringComparer.Ordinal));

        int Column(params string[] any)
        {
            var at = Find(any);
            return at < 0
                ? throw InputException.At(
                    "missing-column",
                    file,
                    $"found a header with the columns {string.Join(", ", names.Take(20).Select(ProbingLogReader.Shown))}; expected "
                        + $"{any[0]} among them.",
                    head + 1)
                : names.Count(n => any.Contains(n, StringComparer.Ordinal)) > 1
                    ? throw InputException.At("duplicate-column", file, $"found two columns for {any[0]}; expected it once.", head + 1)
                    : at;
        }
    }

    /// <summary>The column separator of a table with this header.</summary>
    public static char DelimiterOf(string header) =>
        header.Contains(';', StringComparison.Ordinal) ? ';' : header.Contains('\t', StringComparison.Ordinal) ? '\t' : ',';

    /// <summary>The number in a point's name: 12, P12, point 12.</summary>
    /// <returns>The number, or -1 if there is none.</returns>
    public static int NumberOf(string label)
    {
        var digits = label.Length;
        while (digits > 0 && char.IsAsciiDigit(label[digits - 1]))
        {
            digits--;
        }

        return int.TryParse(label.AsSpan(digits), NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            && !label.AsSpan(0, digits).ContainsAny(OfNumbers)
            ? number
            : -1;
    }

    private int Label(string label, int row, int column) => NumberOf(label) is >= 0 and var number
        ? number
        : throw InputException.At(
            "bad-number", file, $"found {ProbingLogReader.Shown(label)}; expected the number of a point of the plan.", row + 1, column + 1);

    private double Number(string[] cells, int column, int row)
    {
        var text = cells[column].Trim().Trim('"');
        return double.TryParse(
            text,
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
            CultureInfo.InvariantCulture,
            out var value)
            && double.IsFinite(value)
            ? value
            : throw InputException.At(
                "bad-number",
                file,
                $"found {ProbingLogReader.Shown(text)}; expected a coordinate in millimetres with a decimal point.",
                row + 1,
                column + 1);
    }

    private int Whole(string[] cells, int column, int row)
    {
        var text = cells[column].Trim().Trim('"');
        return int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var value)
            ? value
            : throw InputException.At(
                "bad-number", file, $"found {ProbingLogReader.Shown(text)}; expected a whole number as in plan.csv.", row + 1, column + 1);
    }
}
