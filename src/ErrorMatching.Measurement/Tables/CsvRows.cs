using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Splits text into records (RFC 4180: a quoted cell may contain delimiters, doubled quotation marks and line breaks).</summary>
internal static class CsvRows
{
    // No gauge writes more. For a line of delimiters, the parser needs a hundred times its size, so limits are checked before parsing.
    private const int MostColumns = 1_000;
    private const int MostLines = 1_000_000;
    private const int MostCells = 4_000_000;

    /// <summary>Returns the nonblank records.</summary>
    /// <param name="text">The text of the table.</param>
    /// <param name="file">The file name, as given by the caller.</param>
    /// <param name="firstLine">The line of the file at which the text starts.</param>
    /// <param name="delimiter">The cell separator.</param>
    /// <exception cref="InputException">Too many columns, lines or cells, or a quotation mark is unclosed or misplaced.</exception>
    public static IEnumerable<CsvRow> Read(string text, string file, int firstLine, char delimiter)
    {
        ThrowIfTooMany(text, file, firstLine, delimiter);
        string? badField = null;
        var configuration = new CsvConfiguration(CultureInfo.InvariantCulture)
        {
            Delimiter = delimiter.ToString(),
            IgnoreBlankLines = false,
            BadDataFound = found => badField = found.Field,
        };
        using var parser = new CsvParser(new StringReader(text), configuration);
        // Counts lines independently of the parser, whose own count may change between versions for quoted line breaks.
        for (var line = firstLine; parser.Read(); line += LineBreaks.Count(parser.RawRecord))
        {
            var texts = new string[parser.Count];
            var lines = LineBreaks.Count(parser.RawRecord.AsSpan().TrimEnd("\r\n")) > 0 ? new int[texts.Length] : null;
            for (var (i, cellLine) = (0, line); i < texts.Length; i++)
            {
                texts[i] = parser[i];
                lines?[i] = cellLine;
                if (badField is not null)
                {
                    throw BadQuote(new(file, cellLine, i + 1), badField);
                }

                cellLine += LineBreaks.Count(texts[i]);
            }

            var row = new CsvRow(file, line, texts, lines);
            if (!row.IsBlank)
            {
                yield return row;
            }
        }
    }

    // Counts delimiters in quoted cells too, because only the parser recognizes quotes.
    private static void ThrowIfTooMany(string text, string file, int firstLine, char delimiter)
    {
        var (line, cells) = (firstLine, 0);
        for (var start = 0; start < text.Length; line++)
        {
            var end = LineBreaks.NextLine(text, start);
            var columns = text.AsSpan(start..end).Count(delimiter) + 1;
            cells += columns;
            if (columns > MostColumns)
            {
                throw new Place(file, line, MostColumns + 1).Fail(
                    MeasurementError.TooManyCells,
                    $"a line of {columns} cells",
                    $"at most {MostColumns} in a line: is this the right file?");
            }

            if (line - firstLine >= MostLines || cells > MostCells)
            {
                throw new Place(file, line, 1).Fail(
                    MeasurementError.TooManyCells,
                    $"more than {(cells > MostCells ? MostCells : MostLines)} {(cells > MostCells ? "cells" : "lines")}",
                    "a shorter table: is this the right file?");
            }

            start = end;
        }
    }

    private static InputException BadQuote(Place place, string field) =>
        field.AsSpan().Count('"') % 2 != 0 && field.StartsWith('"')
            ? place.Fail(
                MeasurementError.UnclosedQuote,
                "a quotation mark that nothing closes: " + MeasurementRefusal.Quote(field),
                "a second one at the end of the cell, or none")
            : place.Fail(
                MeasurementError.BadQuote,
                "a quotation mark inside a cell: " + MeasurementRefusal.Quote(field),
                "quotation marks around the whole cell, and doubled inside it");
}
