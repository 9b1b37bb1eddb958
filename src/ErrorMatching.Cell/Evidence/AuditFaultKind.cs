namespace ErrorMatching.Cell;

/// <summary>What was done to an audit trail.</summary>
public enum AuditFaultKind
{
    /// <summary>An entry is not what was written.</summary>
    Changed,

    /// <summary>Entries are missing.</summary>
    Removed,

    /// <summary>An entry stands there that was not written in its place.</summary>
    Inserted,

    /// <summary>Entries stand in another order than that in which they were written.</summary>
    Reordered,

    /// <summary>The end of the trail was written without the key that seals it.</summary>
    Unsealed,
}
