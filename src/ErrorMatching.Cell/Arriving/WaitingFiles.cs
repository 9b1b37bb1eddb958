namespace ErrorMatching.Cell;

/// <summary>Counts the files that wait in a gauge's folder, finished or not, and says since when the oldest waits. It only lists: it opens
/// no file, and ends after some thousand.</summary>
/// <param name="gauge">The gauge.</param>
/// <param name="clock">The clock.</param>
internal sealed class WaitingFiles(GaugeSettings gauge, TimeProvider clock)
{
    /// <summary>More files are not counted.</summary>
    public const int Most = 10_000;

    private static readonly EnumerationOptions All = new() { AttributesToSkip = FileAttributes.None, IgnoreInaccessible = false };
    private readonly FinishedFiles _files = new(gauge, clock);
    private Dictionary<(string Name, DateTime Changed), DateTimeOffset>? _seen;

    /// <summary>Counts once. A file waits from when it was seen first, for its own time may be that of another computer or of a copy. One
    /// that was there before anybody looked waits from the time that it bears.</summary>
    /// <returns>How many files wait, at most <see cref="Most"/>, and since when the oldest waits.</returns>
    public (int Count, DateTimeOffset? Since) Count()
    {
        if (gauge.Incoming is not { } folder) return (0, null);
        var now = clock.GetUtcNow();
        var seen = new Dictionary<(string, DateTime), DateTimeOffset>();
        foreach (var file in Files(folder).Concat(Files(Path.Combine(folder, ClaimFolder.Name))).Where(f => _files.IsOurs(f.Name)))
        {
            if (!file.Exists) continue;
            var key = (file.Name, file.LastWriteTimeUtc);
            seen[key] = _seen is null ? Earlier(new(file.LastWriteTimeUtc), now) : _seen.GetValueOrDefault(key, now);
            if (seen.Count == Most) break;
        }

        _seen = seen;
        return (seen.Count, seen.Count == 0 ? null : seen.Values.Min());
    }

    // A folder that cannot be read is reported by those who take files from it.
    private static IEnumerable<FileInfo> Files(string folder)
    {
        try
        {
            return Directory.Exists(folder) ? [.. new DirectoryInfo(folder).EnumerateFiles("*", All).Take(2 * Most)] : [];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    private static DateTimeOffset Earlier(DateTimeOffset a, DateTimeOffset b) => a < b ? a : b;
}
