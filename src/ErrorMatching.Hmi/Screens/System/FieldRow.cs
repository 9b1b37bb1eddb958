namespace ErrorMatching.Hmi;

/// <summary>Fields that stand beside each other under a name.</summary>
/// <param name="Title">The name; empty for none.</param>
/// <param name="Cells">The fields.</param>
/// <param name="Remove">Takes the row away; null where it stays.</param>
/// <param name="RemoveId">Identifies the button for that.</param>
public sealed record FieldRow(string Title, IReadOnlyList<EditField> Cells, Command? Remove = null, string RemoveId = "")
{
    /// <summary>How many fields have room side by side, so that those of several rows stand under each other;
    /// 0 for as many as there are.</summary>
    public int Columns { get; init; }

    /// <summary>True if it can be taken away.</summary>
    public bool CanRemove => Remove is not null;

    /// <summary>True if it has a name.</summary>
    public bool HasTitle => Title.Length > 0;
}
