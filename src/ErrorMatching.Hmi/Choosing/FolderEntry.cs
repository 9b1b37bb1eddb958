using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>A listed folder or file.</summary>
/// <param name="Path">Its full path.</param>
/// <param name="IsFolder">True for a folder.</param>
/// <param name="ChangedAt">Time of its last change.</param>
/// <param name="Changed">The same, in the format of the display language.</param>
/// <param name="Size">Its size; empty for a folder, or if unknown.</param>
public sealed record FolderEntry(string Path, bool IsFolder, DateTimeOffset ChangedAt, string Changed, string Size)
{
    /// <summary>Its name. Each invisible character that could make it look like another name is replaced by a sign.</summary>
    public string Name { get; } = Visible(System.IO.Path.GetFileName(Path));

    public string Icon => IsFolder ? "Icon.folder" : "Icon.file";

    public string AutomationId => "entry-" + Name;

    /// <summary>The entry with its time in the format of the current display language.</summary>
    /// <param name="clock">Gives the time zone.</param>
    public FolderEntry Now(TimeProvider clock) => this with { Changed = Shown.Time(ChangedAt, clock) };

    internal static string Visible(string name) =>
        string.Concat(name.Select(
            c => char.IsControl(c)
                || CharUnicodeInfo.GetUnicodeCategory(c) is UnicodeCategory.Format
                    or UnicodeCategory.LineSeparator
                    or UnicodeCategory.ParagraphSeparator
                ? '\u25A1'
                : c));
}
