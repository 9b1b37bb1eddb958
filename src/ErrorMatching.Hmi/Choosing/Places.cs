namespace ErrorMatching.Hmi;

/// <summary>Where files usually are: the samples, the cell, where something was chosen lately, the user's own folder, disks and sticks.</summary>
internal static class Places
{
    // Below these disks and sticks are mounted, in a folder of whoever plugged them in where the desktop does it. What is mounted deeper is no disk of a person.
    private static readonly (string Root, int Levels)[] Mounts = [("/media", 2), ("/run/media", 2), ("/mnt", 1)];

    /// <summary>The places of this computer. To be called beside the screen.</summary>
    /// <param name="cellFolder">The folder of the cell's configuration.</param>
    /// <param name="samplesFolder">The folder of the samples; null where there is none.</param>
    /// <param name="recent">Folders in which something was chosen, the latest first.</param>
    public static IReadOnlyList<Place> Of(string cellFolder, string? samplesFolder, IEnumerable<string> recent)
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
        return [.. all.DistinctBy(p => p.Path, StringComparer.Ordinal).Select((p, i) => new Place(i, p.NameKey, p.Path, p.Icon))];
    }

    /// <summary>Of what is mounted on Linux, what a person takes for a disk.</summary>
    /// <param name="mounted">Where something is mounted.</param>
    internal static IEnumerable<string> DisksAmong(IEnumerable<string> mounted) =>
        mounted.Where(d => d == "/" || Mounts.Any(m => d.StartsWith(m.Root + "/", StringComparison.Ordinal) && d.AsSpan(m.Root.Length).Count('/') <= m.Levels));

    // Of what is mounted on Linux most is the system's own. Nothing is asked of a disk itself: one that is gone would let the question wait.
    private static IEnumerable<string> Disks() => OperatingSystem.IsWindows()
        ? Environment.GetLogicalDrives()
        : DisksAmong(Environment.GetLogicalDrives());
}
