namespace ErrorMatching.Cell;

/// <summary>Search criteria for the history. Null criteria are ignored; all others must match.</summary>
public sealed record HistoryQuery
{
    /// <summary>True if part of a serial number, work order, program name or user matches too, in any case: for text that a person
    /// types.</summary>
    public bool IsLoose { get; init; }

    /// <summary>Serial number of the piece.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order of the piece, or of its job if the piece has none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Arrived at this time or later.</summary>
    public DateTimeOffset? From { get; init; }

    /// <summary>Arrived before this time.</summary>
    public DateTimeOffset? To { get; init; }

    /// <summary>Name of the program at the machine, or SHA-256 of the compensated program or at least its first 8 digits.</summary>
    public string? Program { get; init; }

    /// <summary>The user who took any of its steps.</summary>
    public string? User { get; init; }

    /// <summary>Its state.</summary>
    public CorrectionState? State { get; init; }

    /// <summary>The machine that its program is for.</summary>
    public string? Machine { get; init; }

    /// <summary>Maximum number of results; the latest are returned.</summary>
    public int Most { get; init; } = 100;
}

/// <summary>Searches the history of a store.</summary>
internal static class HistorySearch
{
    private const int FewestDigits = 8;
    private const int Recent = 20_000;

    /// <summary>The corrections that match, last arrival first.</summary>
    public static IReadOnlyList<Correction> Find(CellDatabase database, HistoryQuery query) =>
        Search(database, query, isCounted: false).Latest;

    /// <summary>The number of corrections that match, whatever <see cref="HistoryQuery.Most"/> says.</summary>
    public static long Count(CellDatabase database, HistoryQuery query) => Search(database, query, isCounted: true).All;

    private static (IReadOnlyList<Correction> Latest, long All) Search(CellDatabase database, HistoryQuery query, bool isCounted)
    {
        if (Period(database, query) is not var (first, last)) return ([], 0);
        var but = query with { User = null, From = null, To = null, Most = 0, IsLoose = false };
        var isByUser = query.User is not null && but == new HistoryQuery { Most = 0 };
        SqlArguments parameters = [
            ("Recent", Recent),
            ("Serial", Looked(query.Serial)),
            ("WorkOrder", Looked(query.WorkOrder)),
            ("From", From(query)),
            ("To", To(query)),
            ("First", first),
            ("Last", last),
            ("Program", Looked(query.Program)),
            ("Hash", Hash(query.Program)),
            ("HashEnd", Hash(query.Program)?.PadRight(64, 'f')),
            ("User", Looked(query.User)),
            ("State", query.State is { } state ? CorrectionRow.Word(state) : null),
            ("Machine", StoredText.NameOrNull(query.Machine)),
            ("Most", query.Most),
        ];

        var took = query.User is null ? "1 = 1" : $"EXISTS (SELECT 1 FROM step WHERE step.correction = correction.id AND {User()})";

        // Somebody who took no step is not looked for in thousands of corrections.
        if (query.User is not null
            && database.Read(connection => Cell.Rows.Query(
                connection, $"SELECT 1 FROM step WHERE {User()} LIMIT 1", r => r.GetInt32(0), parameters)).Count == 0)
            return ([], 0);
        var byAny = isByUser ? $"id IN (SELECT correction FROM step WHERE {User()})" : took;
        if (isCounted)
        {
            return ([], database.Read(connection => Cell.Rows.Query(
                connection, $"SELECT count(*) FROM correction WHERE {Where(true, "1 = 1", byAny)}", r => r.GetInt64(0), parameters))[0]);
        }

        // What occurs often is found among the latest, without sorting all of it; what is rare is found by an index.
        var latest = Rows(false, "id > @Last - @Recent", took);
        return (latest.Count >= query.Most ? latest : Rows(true, "1 = 1", byAny), 0);

        IReadOnlyList<Correction> Rows(bool isAll, string among, string by) => database.Read(connection => Cell.Rows.Query(
            connection,
            $"{CorrectionRow.Select} WHERE {Where(isAll, among, by)} ORDER BY id DESC LIMIT @Most",
            CorrectionRow.Read,
            parameters));

        string Where(bool isAll, string among, string by) => string.Join(" AND ", Conditions(isAll).Prepend(among).Append(by));

        List<string> Conditions(bool isAll)
        {
            var conditions = new List<string>();
            if (query.Serial is not null) conditions.Add(Has("serial", "@Serial", isAll));
            if (query.WorkOrder is not null) conditions.Add(WorkOrders(isAll));

            // A sum is looked up by no index: the rows of a period are found by number, in order, and not sorted by the thousand.
            if (query.From is not null) conditions.Add("arrived_at + 0 >= @From");
            if (query.To is not null) conditions.Add("arrived_at + 0 < @To");
            if ((query.From is not null || query.To is not null) && !(isAll && isByUser)) conditions.Add("id BETWEEN @First AND @Last");
            if (query.Program is not null)
                conditions.Add(
                    Hash(query.Program) is null
                        ? Known("program", "@Program", isAll)
                        : $"({Known("program", "@Program", isAll)} OR program_sha256 BETWEEN @Hash AND @HashEnd)");
            if (query.State is not null) conditions.Add("state = @State");
            if (query.Machine is not null) conditions.Add("machine = @Machine");
            return conditions;
        }

        string User() => query.IsLoose ? Among("step", "who", "@User") : Is("who", "@User");

        // Among all, each of the two columns by its own index: with both in one condition, every row would be read, and by the index of
        // those without a work order, all of those.
        string WorkOrders(bool isAll)
        {
            var (own, ofJob) = (Known("work_order", "@WorkOrder", isAll),
                $"CASE WHEN work_order IS NULL THEN 1 ELSE 0 END = 1 AND {Known("job_work_order", "@WorkOrder", isAll)}");
            return isAll ? $"id IN (SELECT id FROM correction WHERE {own} UNION ALL SELECT id FROM correction WHERE {ofJob})"
                : $"({own} OR ({ofJob}))";
        }

        string Is(string column, string parameter) =>
            query.IsLoose ? $"{column} {database.Like} {parameter} ESCAPE '!'" : $"{column} = {parameter}";

        // Part of a name is looked for among the names of an index, which are a tenth of the rows' bytes.
        string Has(string column, string parameter, bool isAll) =>
            query.IsLoose && isAll
                ? $"{column} IN (SELECT DISTINCT {column} FROM correction WHERE {Is(column, parameter)})"
                : Is(column, parameter);

        // A condition on a column of few names.
        string Known(string column, string parameter, bool isAll) =>
            query.IsLoose && isAll ? Among("correction", column, parameter) : Is(column, parameter);

        // Few names are in many rows: each is found by the index from the one before.
        string Among(string table, string column, string parameter) =>
            $"{column} IN (WITH RECURSIVE known (name) AS (SELECT min({column}) FROM {table} UNION ALL SELECT (SELECT min({column}) FROM "
                + $"{table} WHERE {column} > known.name) FROM known WHERE known.name IS NOT NULL) SELECT name FROM known WHERE "
                + $"{Is("name", parameter)})";

        string? Looked(string? name) => StoredText.NameOrNull(name) is { } text && query.IsLoose
            ? "%"
                + text.Replace("!", "!!", StringComparison.Ordinal)
                    .Replace("%", "!%", StringComparison.Ordinal)
                    .Replace("_", "!_", StringComparison.Ordinal)
                + "%"
            : StoredText.NameOrNull(name);
    }

    // Numbers follow arrivals but for clocks that were set back, so a period is a range of numbers with few others in it. Null for none.
    private static (long First, long Last)? Period(CellDatabase database, HistoryQuery query) =>
        database.Read(connection => Rows.Query(
            connection,
            query.From is null && query.To is null ? "SELECT 0, max(id) FROM correction"
                : "SELECT min(id), max(id) FROM correction WHERE arrived_at >= @From AND arrived_at < @To",
            r => r.IsDBNull(1) ? ((long, long)?)null : (r.GetInt64(0), r.GetInt64(1)),
            [("From", From(query)), ("To", To(query))])[0]);

    private static long From(HistoryQuery query) => query.From is { } from ? StoredTime.Of(from) : long.MinValue;

    private static long To(HistoryQuery query) => query.To is { } to ? StoredTime.Of(to) : long.MaxValue;

    // The first digits of a hash, if the search term for the program is one.
    private static string? Hash(string? program) =>
        program?.Length is >= FewestDigits and <= 64 && program.All(char.IsAsciiHexDigit) ? program.ToLowerInvariant() : null;
}
