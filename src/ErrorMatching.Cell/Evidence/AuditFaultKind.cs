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

    /// <summary>An entry is what was written and must not have come about: a step that is none, or by somebody who may not.</summary>
    NotAllowed,

    /// <summary>A row of the store is not what the trail says of it.</summary>
    RowDiffers,

    /// <summary>The database has a table, column, index, trigger or other thing that the cell did not make, or lacks one.</summary>
    FormDiffers,

    /// <summary>The end of the trail was written without the key that seals it.</summary>
    Unsealed,

    /// <summary>The key that seals the trail is not there: whether its end was cut off, or all of it written again, cannot be said.</summary>
    KeysMissing,

    /// <summary>What says how far the trail went is not there: whether the store was set back cannot be said.</summary>
    WitnessMissing,
}
