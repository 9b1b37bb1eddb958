namespace ErrorMatching.Hmi;

/// <summary>A folder to start at, one tap away.</summary>
/// <param name="Number">Its index in the list, from 0.</param>
/// <param name="NameKey">Key of its display name; null to show the folder's own name.</param>
/// <param name="Path">Its full path.</param>
/// <param name="Icon">Key of its icon.</param>
public sealed record Place(int Number, string? NameKey, string Path, string Icon)
{
    /// <summary>Its display name.</summary>
    public string Name =>
        NameKey is not null
            ? Texts.Current[NameKey]
            : System.IO.Path.GetFileName(System.IO.Path.TrimEndingDirectorySeparator(Path)) is { Length: > 0 } name
            ? FolderEntry.Visible(name)
            : Path;

    public string AutomationId => "place-" + Shown.Id(Number);
}
