namespace ErrorMatching.Hmi;

/// <summary>Where files usually are: the samples, the cell, where something was chosen lately, the user's own folder, disks and sticks.</summary>
internal static class Places
{
    private static readonly string[] Mounts = ["/media", "/run/media", "/mnt"];

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

    // Of what is mounted on Linux most is the system's own. Nothing is asked of a disk itself: one that is gone would let the question wait.
    private static IEnumerable<string> Disks() => OperatingSystem.IsWindows()
        ? Environment.GetLogicalDrives()
        : Environment.GetLogicalDrives().Where(d => d == "/" || Mounts.Any(m => d.StartsWith(m + "/", StringComparison.Ordinal)));
}
