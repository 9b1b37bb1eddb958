namespace ErrorMatching.Hmi;

/// <summary>Where files usually are: the samples, the cell, recently used folders, the user's own folder, disks and USB sticks.</summary>
internal static class Places
{
    // Disks and USB sticks are mounted below these; desktops mount them in a folder of the user. Deeper mounts are not a user's disks.
    private static readonly (string Root, int Levels)[] Mounts = [("/media", 2), ("/run/media", 2), ("/mnt", 1)];

    /// <summary>The places of this computer. Call it off the UI thread.</summary>
    /// <param name="cellFolder">The folder of the cell's configuration.</param>
    /// <param name="samplesFolder">The folder of the samples; null if there is none.</param>
    /// <param name="recent">Recently used folders, latest first.</param>
    public static IReadOnlyList<FolderPlace> Of(string cellFolder, string? samplesFolder, IEnumerable<string> recent)
    {
        var home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile);
        (string? NameKey, string Path, string Icon)[] all =
        [
            .. samplesFolder is not null ? [("Chooser.Samples", samplesFolder, "Icon.folder")] : Array.Empty<(string?, string, string)>(),
            ("Chooser.CellFolder", cellFolder, "Icon.folder"),
            .. home.Length > 0 ? [("Chooser.Home", home, "Icon.user")] : Array.Empty<(string?, string, string)>(),
            .. Disks().Select(d => ((string?)null, d, "Icon.disk")),
            .. recent.Select(r => ((string?)null, r, "Icon.history")),
        ];
        return [.. all.DistinctBy(p => p.Path, StringComparer.Ordinal).Select((p, i) => new FolderPlace(i, p.NameKey, p.Path, p.Icon))];
    }

    /// <summary>Selects the mount points on Linux that a user would call a disk.</summary>
    /// <param name="mounted">The mount points.</param>
    internal static IEnumerable<string> DisksAmong(IEnumerable<string> mounted) =>
        mounted.Where(
            d => d == "/"
                || Mounts.Any(m => d.StartsWith(m.Root + "/", StringComparison.Ordinal) && d.AsSpan(m.Root.Length).Count('/') <= m.Levels));

    // On Linux, most mount points belong to the system. The disks themselves are not accessed: a disconnected one could block.
    private static IEnumerable<string> Disks() => OperatingSystem.IsWindows()
        ? Environment.GetLogicalDrives()
        : DisksAmong(Environment.GetLogicalDrives());
}

/// <summary>A folder to start at, one tap away.</summary>
/// <param name="Number">Its index in the list, from 0.</param>
/// <param name="NameKey">Key of its display name; null to show the folder's own name.</param>
/// <param name="Path">Its full path.</param>
/// <param name="Icon">Key of its icon.</param>
public sealed record FolderPlace(int Number, string? NameKey, string Path, string Icon)
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
