using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>A folder or file in a folder, as it is shown.</summary>
/// <param name="Path">Its full path.</param>
/// <param name="IsFolder">True for a folder.</param>
/// <param name="ChangedAt">When it was last changed.</param>
/// <param name="Changed">The same by the custom of the language in which it is shown.</param>
/// <param name="Size">Its length; empty for a folder and for what cannot be asked.</param>
public sealed record FolderEntry(string Path, bool IsFolder, DateTimeOffset ChangedAt, string Changed, string Size)
{
    /// <summary>Its name, with a sign in place of each character that cannot be seen and could make it look like another one.</summary>
    public string Name { get; } = Visible(System.IO.Path.GetFileName(Path));

    /// <summary>Key of its icon.</summary>
    public string Icon => IsFolder ? "Icon.folder" : "Icon.file";

    /// <summary>Identifies the row.</summary>
    public string AutomationId => "entry-" + Name;

    /// <summary>The entry with its time by the custom of the language that is shown now.</summary>
    /// <param name="clock">For the zone of times.</param>
    public FolderEntry Now(TimeProvider clock) => this with { Changed = Shown.Time(ChangedAt, clock) };

    internal static string Visible(string name) =>
        string.Concat(name.Select(c => char.IsControl(c) || CharUnicodeInfo.GetUnicodeCategory(c) is UnicodeCategory.Format or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator ? '\u25A1' : c));
}
