namespace ErrorMatching.Cell;

/// <content>The audit trail and the history.</content>
public sealed partial class CellStore
{
    /// <summary>Records an act that is no step of a correction.</summary>
    /// <param name="who">The user's name, or <c>cell</c>.</param>
    /// <param name="what">What was done, in one word.</param>
    /// <param name="basis">On what basis, in words.</param>
    /// <param name="subject">What it was done to; null if it was to nothing in particular.</param>
    public void Audit(string who, string what, string basis, string? subject = null) => Write(transaction =>
    {
        transaction.Audit(who, what, subject, basis);
        return true;
    });

    /// <summary>Entries of the audit trail, in order.</summary>
    /// <param name="after">The number that they follow; 0 for the first.</param>
    /// <param name="most">The most of them.</param>
    public IReadOnlyList<AuditEntry> AuditEntries(long after, int most) =>
        Read(AuditRow.Select + " WHERE seq > @after ORDER BY seq LIMIT @most", AuditRow.Read, new { after, most });

    /// <summary>Where the audit trail ends.</summary>
    public AuditHead AuditHead() => Database.Read(connection => AuditRow.Head(connection, null, ""));
}
