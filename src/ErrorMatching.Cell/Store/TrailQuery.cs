using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Search criteria for the audit trail. Null criteria are ignored; all others must match.</summary>
public sealed record TrailQuery
{
    /// <summary>Part of the name of who did it, in any case.</summary>
    public string? Who { get; init; }

    /// <summary>Part of what it was done to, in any case: of the serial number, work order or job of its correction, or of the entry's
    /// subject.</summary>
    public string? About { get; init; }

    /// <summary>What was done: one of these words.</summary>
    public IReadOnlyList<string>? What { get; init; }

    /// <summary>Done at this time or later.</summary>
    public DateTimeOffset? From { get; init; }

    /// <summary>Done before this time.</summary>
    public DateTimeOffset? To { get; init; }

    /// <summary>Only entries after this number.</summary>
    public long After { get; init; }

    /// <summary>Maximum number of results; the latest are returned.</summary>
    public int Most { get; init; } = 200;
}

/// <summary>Searches the audit trail of a store. It reads the trail from its end until enough is found: the rarer the entries, the longer,
/// up to a time that grows with the trail.</summary>
internal static class TrailSearch
{
    private const string OfCorrection = "correction ";
    private static readonly string[] Named = ["serial", "work_order", "job_work_order", "job"];

    /// <summary>The entries that match, latest first.</summary>
    public static IReadOnlyList<AuditEntry> Find(CellDatabase database, TrailQuery query)
    {
        List<string> conditions = ["seq > @After"];
        SqlArguments parameters = [
            ("After", query.After),
            ("Who", Part(query.Who)),
            ("About", Part(query.About)),
            ("From", query.From is { } from ? StoredTime.Of(from) : long.MinValue),
            ("To", query.To is { } to ? StoredTime.Of(to) : long.MaxValue),
        ];
        if (query.Who is not null) conditions.Add($"who {database.Like} @Who ESCAPE '!'");
        if (query.From is not null) conditions.Add("at >= @From");
        if (query.To is not null) conditions.Add("at < @To");
        if (query.What is { } words)
        {
            // The words are the program's own.
            conditions.Add($"what IN ({string.Join(", ", words.Select(w => $"'{w.Replace("'", "''", StringComparison.Ordinal)}'"))})");
        }

        return database.Read(connection =>
        {
            HashSet<long>? ids = query.About is null ? null : [
                .. Rows.Query(
                    connection,
                    "SELECT id FROM correction WHERE " + string.Join(
                        " OR ",
                        Named.Select(c => $"{c} {database.Like} @About ESCAPE '!'")),
                    r => r.GetInt64(0),
                    parameters)];
            var entries = Rows.Stream(
                connection, $"{AuditRow.Select} WHERE {string.Join(" AND ", conditions)} ORDER BY seq DESC", AuditRow.Read, parameters);
            return (IReadOnlyList<AuditEntry>)[.. entries.Where(e => ids is null || IsAbout(e, query.About!, ids)).Take(query.Most)];
        });
    }

    private static bool IsAbout(AuditEntry entry, string part, HashSet<long> ids) =>
        entry.Subject?.Sentence is { } subject
        && (subject.Contains(part, StringComparison.OrdinalIgnoreCase)
            || (subject.StartsWith(OfCorrection, StringComparison.Ordinal) && ids.Contains(NumberIn(subject))));

    private static long NumberIn(string subject)
    {
        var digits = subject[OfCorrection.Length..].TakeWhile(char.IsAsciiDigit).ToArray();
        return long.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var id) ? id : 0;
    }

    private static string? Part(string? text) => text is null ? null
        : "%"
            + text.Replace("!", "!!", StringComparison.Ordinal)
                .Replace("%", "!%", StringComparison.Ordinal)
                .Replace("_", "!_", StringComparison.Ordinal)
            + "%";
}
