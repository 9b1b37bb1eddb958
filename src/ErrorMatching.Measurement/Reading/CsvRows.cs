using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;

namespace ErrorMatching.Measurement;

/// <summary>Splits text into records (RFC 4180: a quoted cell may hold delimiters, doubled quotation marks and line breaks).</summary>
internal static class CsvRows
{
    /// <summary>The records that are not blank.</summary>
    /// <param name="text">The text of the table.</param>
    /// <param name="file">The file as the caller named it.</param>
    /// <param name="firstLine">The line of the file in which the text starts.</param>
    /// <param name="delimiter">What stands between two cells.</param>
    /// <exception cref="MeasurementException">A quotation mark is not closed, or stands where none may.</exception>
    public static IEnumerable<CsvRow> Read(string text, string file, int firstLine, char delimiter)
    {
        string? badField = null;
        var configuration = new CsvConfiguration(CultureInfo.InvariantCulture)
        {
            Delimiter = delimiter.ToString(),
            IgnoreBlankLines = false,
            BadDataFound = found => badField = found.Field,
        };
        using var parser = new CsvParser(new StringReader(text), configuration);
        // The parser's own count of lines is not used: a test of it with quoted line breaks would be a test of its next version too.
        for (var line = firstLine; parser.Read(); line += LineBreaks.Count(parser.RawRecord))
        {
            var (texts, lines) = (new string[parser.Count], new int[parser.Count]);
            for (var (i, cellLine) = (0, line); i < texts.Length; i++)
            {
                texts[i] = parser[i];
                lines[i] = cellLine;
                if (badField is not null)
                {
                    throw BadQuote(new(file, cellLine, i + 1), badField);
                }

                cellLine += LineBreaks.Count(texts[i]);
            }

            var row = new CsvRow(file, texts, lines);
            if (!row.IsBlank)
            {
                yield return row;
            }
        }
    }

    private static MeasurementException BadQuote(Place place, string field) =>
        field.AsSpan().Count('"') % 2 != 0 && field.StartsWith('"')
            ? place.Fail(MeasurementError.UnclosedQuote, "a quotation mark that nothing closes: " + MeasurementException.Quote(field), "a second one at the end of the cell, or none")
            : place.Fail(MeasurementError.BadQuote, "a quotation mark inside a cell: " + MeasurementException.Quote(field), "quotation marks around the whole cell, and doubled inside it");
}
