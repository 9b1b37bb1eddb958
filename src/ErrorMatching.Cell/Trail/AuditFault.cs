namespace ErrorMatching.Cell;

/// <summary>The first place where an audit trail differs from what was written.</summary>
/// <param name="Kind">The kind of fault.</param>
/// <param name="Seq">The correct number of the first entry that is changed, missing, inserted or out of order.</param>
/// <param name="Message">A sentence that describes it.</param>
public sealed record AuditFault(AuditFaultKind Kind, long Seq, string Message);

/// <summary>What is wrong with an audit trail.</summary>
public enum AuditFaultKind
{
    /// <summary>An entry differs from what was written.</summary>
    Changed,

    /// <summary>Entries are missing.</summary>
    Removed,

    /// <summary>An entry was inserted.</summary>
    Inserted,

    /// <summary>Entries are out of order.</summary>
    Reordered,

    /// <summary>An entry is as written but must not exist: its step is not allowed, or its user had no right to take it.</summary>
    NotAllowed,

    /// <summary>A row of the store differs from what the trail says.</summary>
    RowDiffers,

    /// <summary>The database has an extra table, column, index, trigger or other object that the cell did not create, or lacks
    /// one.</summary>
    FormDiffers,

    /// <summary>The end of the trail was written without the key that seals it.</summary>
    Unsealed,

    /// <summary>The key that seals the trail is missing, so a cut-off end or a rewritten trail cannot be detected.</summary>
    KeysMissing,

    /// <summary>The record of how far the trail went is missing, so a rollback of the store cannot be detected.</summary>
    WitnessMissing,
}
