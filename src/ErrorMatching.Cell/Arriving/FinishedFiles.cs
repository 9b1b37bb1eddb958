using System.Text;
using ErrorMatching.Measurement;

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
        var names = items.ToDictionary(i => i.Name, StringComparer.Ordinal);
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
            else if (item is FileInfo file)
            {
                // Asked first: the rest of a description is counted from when it is first seen.
                var isDescribed = IsDescribed(file, names, seen);
                if (IsFinished(file, names, seen))
                {
                    if (isDescribed)
                    {
                        finished.Add(file);
                        continue;
                    }

                    left.Add(new(ShownName.Of(file.Name), Undescribed(file.Name)));
                }

                IsWaiting = true;
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
        && !MeasurementBytes.IsDescription(name)
        && !(gauge.Finished is FinishedByMarker marker && name.EndsWith(marker.Suffix, StringComparison.OrdinalIgnoreCase));

    /// <summary>Why values are not taken alone.</summary>
    public static string Undescribed(string name) =>
        $"its description {ShownName.Of(MeasurementBytes.DescriptionsOf(name)[0])} is not there yet, or is still being written, "
            + $"and both are taken together. Put it into the same folder, or export one file .dfq.";

    // Values are taken with their description. A marker or an end of the values speaks for both; a description that is still being written
    // is waited for.
    private bool IsDescribed(
        FileInfo file,
        Dictionary<string, FileSystemInfo> names,
        Dictionary<string, (long Length, DateTime Changed, long Since, bool HasMark)> seen)
    {
        var descriptions = MeasurementBytes.DescriptionsOf(file.Name);
        return descriptions.Count == 0 || (
            descriptions.Select(d => names.GetValueOrDefault(d)).OfType<FileInfo>().FirstOrDefault() is { Exists: true } description
                && PlainFile.Defect(description) is null
                && (gauge.Finished is not FinishedAtRest || IsFinished(description, names, seen)));
    }

    private bool IsFinished(
        FileInfo file,
        Dictionary<string, FileSystemInfo> names,
        Dictionary<string, (long Length, DateTime Changed, long Since, bool HasMark)> seen)
    {
        switch (gauge.Finished)
        {
            case FinishedByRename:
                return true;
            case FinishedByMarker marker:
                return names.ContainsKey(file.Name + marker.Suffix);
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

/// <summary>Finds out by its last line whether a file is complete.</summary>
internal static class EndMark
{
    // Room for the last line and the blank ones after it; a file with more blanks at its end counts as unfinished.
    private const int Tail = 4096;

    /// <summary>True if the last nonblank line of a file is the mark; false if it is not, or if the file cannot be opened yet.</summary>
    public static bool Ends(FileInfo file, string mark)
    {
        try
        {
            using var handle = PlainFile.Open(file.FullName, FileShare.ReadWrite | FileShare.Delete);
            var tail = new byte[Tail];
            var length = RandomAccess.GetLength(handle);
            var read = RandomAccess.Read(handle, tail, Math.Max(0, length - Tail));
            return Ends(tail.AsSpan(0, read), mark);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    /// <summary>True if the last nonblank line of a content is the mark. The percent sign that a control closes a file with is not a
    /// line.</summary>
    public static bool Ends(ReadOnlySpan<byte> bytes, string mark)
    {
        var line = bytes.TrimEnd(mark.EndsWith('%') ? " \t\r\n\0"u8 : " \t\r\n\0%"u8);
        line = line[(line.LastIndexOfAny("\r\n"u8) + 1)..].TrimStart(" \t"u8);
        return line.SequenceEqual(Encoding.UTF8.GetBytes(mark));
    }
}
