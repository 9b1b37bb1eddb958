namespace ErrorMatching.Cell;

/// <summary>Determines which files in a gauge's folder are finished.</summary>
internal sealed class FinishedFiles(GaugeSettings gauge, TimeProvider clock)
{
    private Dictionary<string, (long Length, DateTime Changed, long Since, bool HasMark)> _seen = new(StringComparer.Ordinal);

    /// <summary>Files that match the pattern and are left where they are.</summary>
    public IReadOnlyList<LeftFile> Left { get; private set; } = [];

    /// <summary>True if a file matches the pattern and is not finished yet.</summary>
    public bool IsWaiting { get; private set; }

    /// <summary>The finished files in a listing, ordered by modification time and name.</summary>
    /// <exception cref="IOException">The folder cannot be listed.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the folder is denied.</exception>
    public IReadOnlyList<FileInfo> Of(DirectoryInfo folder)
    {
        var finished = new List<FileInfo>();
        var left = new List<LeftFile>();
        var seen = new Dictionary<string, (long, DateTime, long, bool)>(StringComparer.Ordinal);
        FileSystemInfo[] items = [
            .. folder.EnumerateFileSystemInfos(
                "*", new EnumerationOptions { AttributesToSkip = FileAttributes.None, IgnoreInaccessible = false })];
        var names = gauge.Finished is FinishedByMarker ? items.Select(i => i.Name).ToHashSet(StringComparer.Ordinal) : [];
        IsWaiting = false;
        foreach (var item in items.Where(i => IsOurs(i.Name)))
        {
            if (!item.Exists)
            {
                // The file has disappeared, or its name cannot be represented as text.
                if (item.Name.Contains('\uFFFD', StringComparison.Ordinal))
                {
                    left.Add(new(ShownName.Of(item.Name), "its name is not written in UTF-8, so it cannot be opened. Rename it."));
                }
            }
            else if (PlainFile.Defect(item) is { } defect)
            {
                left.Add(new(
                    ShownName.Of(item.Name), $"{defect}, and only plain files are taken. Remove it, or put the file itself there."));
            }
            else if (item is FileInfo file && IsFinished(file, names, seen))
            {
                finished.Add(file);
            }
            else
            {
                IsWaiting = true;
            }
        }

        (_seen, Left) = (seen, left);
        return [.. finished.OrderBy(f => f.LastWriteTimeUtc).ThenBy(f => f.Name, StringComparer.Ordinal)];
    }

    /// <summary>True if a name matches the gauge's pattern and is neither a marker nor hidden. Other programs use hidden names for
    /// unfinished files.</summary>
    public bool IsOurs(string name) =>
        FileNamePattern.Fits(gauge.Files, name)
        && (name[0] != '.' || gauge.Files[0] == '.')
        && !(gauge.Finished is FinishedByMarker marker && name.EndsWith(marker.Suffix, StringComparison.OrdinalIgnoreCase));

    private bool IsFinished(
        FileInfo file, HashSet<string> names, Dictionary<string, (long Length, DateTime Changed, long Since, bool HasMark)> seen)
    {
        switch (gauge.Finished)
        {
            case FinishedByRename:
                return true;
            case FinishedByMarker marker:
                return names.Contains(file.Name + marker.Suffix);
            default:
                var (length, changed) = (file.Length, file.LastWriteTimeUtc);
                var now = clock.GetTimestamp();
                if (!_seen.TryGetValue(file.Name, out var before) || before.Length != length || before.Changed != changed)
                {
                    before = (length, changed, now, gauge.Finished is FinishedByEndMark mark && EndMark.Ends(file, mark.Mark));
                }

                seen[file.Name] = before;
                return gauge.Finished is FinishedAtRest rest ? clock.GetElapsedTime(before.Since, now) >= rest.For : before.HasMark;
        }
    }
}

/// <summary>A file that matches a gauge's pattern and is left where it is.</summary>
/// <param name="Name">Its name, made safe for display.</param>
/// <param name="Reason">Why, and what to do, in a setter's terms.</param>
public sealed record LeftFile(string Name, string Reason);
