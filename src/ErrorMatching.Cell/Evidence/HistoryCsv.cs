using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Corrections that a search of the history found, as CSV by RFC 4180 that no spreadsheet executes.</summary>
public static class HistoryCsv
{
    private static readonly string[] Columns =
    [
        "id", "arrived", "file", "job", "piece", "serial", "work order", "state", "largest mm", "machine", "slot", "program",
        "program sha256", "people", "why",
    ];

    /// <summary>Writes a row for each correction, below the names of the columns. Times are UTC; what is not known is empty.</summary>
    /// <param name="writer">The destination.</param>
    /// <param name="corrections">The corrections.</param>
    /// <param name="people">Who took steps of them, by number: see <see cref="CorrectionQueries.PeopleOf"/>.</param>
    public static void Write(
        TextWriter writer, IEnumerable<Correction> corrections, IReadOnlyDictionary<long, IReadOnlyList<string>> people)
    {
        ArgumentNullException.ThrowIfNull(writer);
        ArgumentNullException.ThrowIfNull(corrections);
        ArgumentNullException.ThrowIfNull(people);
        SpreadsheetCsv.Write(writer, Columns);
        foreach (var c in corrections)
        {
            SpreadsheetCsv.Write(
                writer,
                c.Id.ToString(CultureInfo.InvariantCulture),
                c.ArrivedAt.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture),
                c.FileName,
                c.Job ?? "",
                c.Piece ?? "",
                c.Serial ?? "",
                c.WorkOrder ?? c.JobWorkOrder ?? "",
                CorrectionRow.Word(c.State),
                c.LargestMm?.ToString("0.0000", CultureInfo.InvariantCulture) ?? "",
                c.Machine ?? "",
                c.Slot ?? "",
                c.Program ?? "",
                c.ProgramSha256 ?? "",
                string.Join(", ", people.GetValueOrDefault(c.Id, [])),
                c.Code is null ? "" : $"{c.Code}: {c.Reason?.Sentence}");
        }
    }
}
