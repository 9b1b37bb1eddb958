namespace ErrorMatching.Cell;

/// <summary>What is wrong with an audit trail.</summary>
public enum AuditBreak
{
    /// <summary>An entry does not say any more what it said.</summary>
    Changed,

    /// <summary>An entry is missing.</summary>
    Removed,

    /// <summary>An entry was put in.</summary>
    Inserted,

    /// <summary>An entry stands in another's place.</summary>
    Reordered,

    /// <summary>All entries follow each other, and yet the end is not the one that the cell sealed.</summary>
    Resealed,
}
