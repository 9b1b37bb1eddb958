namespace ErrorMatching.Cell;

/// <summary>Searches the history of a store.</summary>
internal static class HistorySearch
{
    private const int FewestDigits = 8;

    /// <summary>The corrections that match, last arrival first.</summary>
    public static IReadOnlyList<Correction> Find(CellDatabase database, HistoryQuery query)
    {
        var conditions = new List<string>();
        if (query.Serial is not null) conditions.Add(Is("serial", "@Serial"));
        if (query.WorkOrder is not null) conditions.Add(Is("COALESCE(work_order, job_work_order)", "@WorkOrder"));
        if (query.From is not null) conditions.Add("arrived_at >= @From");
        if (query.To is not null) conditions.Add("arrived_at < @To");
        if (query.Program is not null)
            conditions.Add(
                Hash(query.Program) is null
                    ? Is("program", "@Program")
                    : $"({Is("program", "@Program")} OR program_sha256 BETWEEN @Hash AND @HashEnd)");
        if (query.User is not null) conditions.Add($"id IN (SELECT correction FROM step WHERE {Is("who", "@User")})");
        if (query.State is not null) conditions.Add("state = @State");
        if (query.Machine is not null) conditions.Add("machine = @Machine");
        var where = conditions.Count == 0 ? "" : " WHERE " + string.Join(" AND ", conditions);
        var sql = CorrectionRow.Select + where + " ORDER BY id DESC LIMIT @Most";
        return database.Read(connection => Rows.Query(connection, sql, CorrectionRow.Read, new
        {
            Serial = Looked(query.Serial),
            WorkOrder = Looked(query.WorkOrder),
            From = query.From is { } from ? StoredTime.Of(from) : 0,
            To = query.To is { } to ? StoredTime.Of(to) : 0,
            Program = Looked(query.Program),
            Hash = Hash(query.Program),
            HashEnd = Hash(query.Program)?.PadRight(64, 'f'),
            User = Looked(query.User),
            State = query.State is { } state ? CorrectionRow.Word(state) : null,
            Machine = StoredText.NameOrNull(query.Machine),
            query.Most,
        }));

        string Is(string column, string parameter) =>
            query.IsLoose ? $"LOWER({column}) LIKE LOWER({parameter}) ESCAPE '!'" : $"{column} = {parameter}";

        string? Looked(string? name) => StoredText.NameOrNull(name) is { } text && query.IsLoose
            ? "%"
                + text.Replace("!", "!!", StringComparison.Ordinal)
                    .Replace("%", "!%", StringComparison.Ordinal)
                    .Replace("_", "!_", StringComparison.Ordinal)
                + "%"
            : StoredText.NameOrNull(name);
    }

    // The first digits of a hash, if the search term for the program is one.
    private static string? Hash(string? program) =>
        program?.Length is >= FewestDigits and <= 64 && program.All(char.IsAsciiHexDigit) ? program.ToLowerInvariant() : null;
}
