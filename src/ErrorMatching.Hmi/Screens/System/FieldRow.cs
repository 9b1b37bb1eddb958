namespace ErrorMatching.Hmi;

/// <summary>Fields side by side under a name.</summary>
/// <param name="Title">The name; empty for none.</param>
/// <param name="Cells">The fields.</param>
/// <param name="Remove">Removes the row; null if it cannot be removed.</param>
/// <param name="RemoveId">Identifies the button for that.</param>
internal sealed record FieldRow(string Title, IReadOnlyList<EditField> Cells, Command? Remove = null, string RemoveId = "")
{
    /// <summary>Number of columns, so that the fields of several rows align; 0 to use the number of fields.</summary>
    public int Columns { get; init; }

    public bool CanRemove => Remove is not null;

    public bool HasTitle => Title.Length > 0;
}
