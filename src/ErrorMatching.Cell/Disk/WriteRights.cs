namespace ErrorMatching.Cell;

/// <summary>Who else may change a file, or put another one in its place: by its own permissions, or by those of a folder on the way to
/// it.</summary>
/// <remarks>The rule is that of sshd (StrictModes), with two exceptions. In a folder with the sticky bit, such as /tmp, nobody replaces
/// the file of another. And nobody gets past a folder that does not let others in. On Windows, nothing is checked: who may write is decided
/// by lists of rights there, and those of a user's own folders admit nobody else.</remarks>
internal static class WriteRights
{
    private const int MostLinks = 40;

    /// <summary>The file or folder by which everybody on this computer may change what is at a path; null if nobody may.</summary>
    /// <param name="path">The absolute path of a file or folder.</param>
    public static string? OfEverybody(string path) => OperatingSystem.IsWindows()
        ? null
        : Find(path, UnixFileMode.OtherWrite, UnixFileMode.OtherExecute, MostLinks);

    /// <summary>The file or folder by which a group may change what is at a path; null if none may.</summary>
    /// <param name="path">The absolute path of a file or folder.</param>
    public static string? OfGroup(string path) => OperatingSystem.IsWindows()
        ? null
        : Find(path, UnixFileMode.GroupWrite, UnixFileMode.GroupExecute, MostLinks);

    /// <summary>The file or folder by which everybody may add files to a folder or change those in it; null if nobody may. The sticky bit
    /// does not help where files are created next to others, as a database's log is.</summary>
    public static string? OfEverybodyInside(string folder) =>
        OfEverybody(folder) ?? (!OperatingSystem.IsWindows() && IsReached(folder) && ModeOf(folder) is { } mode
            && mode.HasFlag(UnixFileMode.OtherWrite | UnixFileMode.OtherExecute) ? folder : null);

    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    private static string? Find(string path, UnixFileMode write, UnixFileMode search, int links)
    {
        foreach (var step in Steps(path))
        {
            if (links > 0 && LinkAt(step) is { } target)
            {
                // The link itself has no permissions; what it leads to has, and the rest of the path is there.
                return Find(
                    Path.GetFullPath(Path.Combine(Path.GetDirectoryName(step)!, target, Path.GetRelativePath(step, path))),
                    write, search, links - 1);
            }

            if (ModeOf(step) is not { } mode)
                return null;
            if (mode.HasFlag(write)
                && (!Directory.Exists(step) || (mode.HasFlag(search) && !mode.HasFlag(UnixFileMode.StickyBit))))
                return step;
            if (step != path && !mode.HasFlag(search))
                return null;
        }

        return null;
    }

    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    private static bool IsReached(string path) =>
        Steps(path).All(s => s == path || ModeOf(s) is not { } mode || mode.HasFlag(UnixFileMode.OtherExecute));

    private static Stack<string> Steps(string path)
    {
        var steps = new Stack<string>();
        for (var step = Path.TrimEndingDirectorySeparator(path); step is not null; step = Path.GetDirectoryName(step))
            steps.Push(step);
        return steps;
    }

    private static string? LinkAt(string path)
    {
        try
        {
            return new FileInfo(path).LinkTarget;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Whoever opens it says so.
            return null;
        }
    }

    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    private static UnixFileMode? ModeOf(string path)
    {
        try
        {
            return File.GetUnixFileMode(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }
}
