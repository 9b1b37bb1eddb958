namespace ErrorMatching.Hmi;

/// <summary>A folder to begin at, one tap away.</summary>
/// <param name="Number">Its place in the list, from 0.</param>
/// <param name="NameKey">Key of the text that people call it by; null if it goes by its own name.</param>
/// <param name="Path">Its full path.</param>
/// <param name="Icon">Key of its icon.</param>
public sealed record Place(int Number, string? NameKey, string Path, string Icon)
{
    /// <summary>What people call it.</summary>
    public string Name => NameKey is not null ? Texts.Current[NameKey] : System.IO.Path.GetFileName(System.IO.Path.TrimEndingDirectorySeparator(Path)) is { Length: > 0 } name ? FolderEntry.Visible(name) : Path;

    /// <summary>Identifies the row.</summary>
    public string AutomationId => "place-" + Shown.Id(Number);
}
