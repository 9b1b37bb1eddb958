using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <content>The audit trail and the history.</content>
public sealed partial class CellStore
{
    private const int FewestDigits = 8;

    /// <summary>Records an act that is not a step of a correction.</summary>
    /// <param name="who">The user's name, or <c>cell</c>.</param>
    /// <param name="what">What was done, in one word.</param>
    /// <param name="basis">The basis.</param>
    /// <param name="subject">What it was done to; null if nothing in particular.</param>
    public void Audit(string who, string what, Statement basis, Statement? subject = null) => Audit(who, what, basis, subject, null);

    /// <summary>The same, and stores the content that the entry refers to, by its hash.</summary>
    internal void Audit(string who, string what, Statement basis, Statement? subject, byte[]? content) => Write(transaction =>
    {
        if (content is not null) Keep(transaction, Sha256(content), content);
        transaction.Audit(who, what, subject, basis);
        return true;
    });

    /// <summary>Entries of the audit trail, in order.</summary>
    /// <param name="after">Returns entries after this number; 0 for the first.</param>
    /// <param name="most">Maximum number of entries.</param>
    public IReadOnlyList<AuditEntry> AuditEntries(long after, int most) =>
        Read(AuditRow.Select + " WHERE seq > @after ORDER BY seq LIMIT @most", AuditRow.Read, new { after, most });

    /// <summary>The end of the audit trail.</summary>
    public AuditHead AuditHead()
    {
        var head = Database.Read(connection => AuditRow.Head(connection, null, ""));
        Database.Saw(head);
        return head;
    }

    /// <summary>Verifies one snapshot of the audit trail with the key that the store was opened with.</summary>
    /// <returns>The first fault; null if every entry is as written and in its place, and none is missing.</returns>
    public AuditFault? VerifyAudit() => Database.Snapshot((connection, transaction) => AuditChain.Verify(
        Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, transaction: transaction),
        AuditRow.Head(connection, transaction, ""),
        _auditKey));

    /// <summary>Searches the history for corrections.</summary>
    /// <returns>The latest matches, last arrival first.</returns>
    public IReadOnlyList<Correction> Search(HistoryQuery query)
    {
        ArgumentNullException.ThrowIfNull(query);
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
        return Read(CorrectionRow.Select + where + " ORDER BY id DESC LIMIT @Most", CorrectionRow.Read, new
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
        });

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
