using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>The contents of a folder: folders first, then files, each sorted by name.</summary>
/// <param name="Folder">Its full path.</param>
/// <param name="Entries">The listed entries.</param>
/// <param name="Hidden">Number of hidden folders and files, which are not listed.</param>
/// <param name="Others">Number of files not listed because of their extension.</param>
/// <param name="IsWhole">False if there is more than was read.</param>
internal sealed record FolderListing(string Folder, IReadOnlyList<FolderEntry> Entries, int Hidden, int Others, bool IsWhole)
{
    /// <summary>Larger than any folder that people browse; if a folder has more entries, the user is told.</summary>
    public const int Most = 10_000;

    private const double BytesOfKilobyte = 1000;

    /// <summary>Lists a folder. Call it off the UI thread: network shares are slow.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="extensions">The extensions to list, each with its dot; empty for all files; null for folders only.</param>
    /// <param name="clock">Gives the time zone.</param>
    /// <param name="cancellation">Cancels the listing.</param>
    /// <exception cref="IOException">It does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static FolderListing Read(string folder, IReadOnlyList<string>? extensions, TimeProvider clock, CancellationToken cancellation)
    {
        var (folders, files) = (new List<FolderEntry>(), new List<FolderEntry>());
        var (seen, hidden, others) = (0, 0, 0);
        var everything = new EnumerationOptions { AttributesToSkip = default, IgnoreInaccessible = false };
        foreach (var found in new DirectoryInfo(folder).EnumerateFileSystemInfos("*", everything))
        {
            cancellation.ThrowIfCancellationRequested();
            if (seen++ == Most)
            {
                break;
            }

            var changed = new DateTimeOffset(found.LastWriteTimeUtc);
            if (found.Attributes.HasFlag(FileAttributes.Hidden))
            {
                hidden++;
            }
            else if (found is DirectoryInfo)
            {
                folders.Add(new(found.FullName, IsFolder: true, changed, Shown.Time(changed, clock), ""));
            }
            else if (extensions is null
                || (extensions.Count > 0 && !extensions.Contains(found.Extension, StringComparer.OrdinalIgnoreCase)))
            {
                others++;
            }
            else
            {
                files.Add(new(found.FullName, IsFolder: false, changed, Shown.Time(changed, clock), SizeOf((FileInfo)found)));
            }
        }

        return new(folder, [.. Sorted(folders), .. Sorted(files)], hidden, others, seen <= Most);
    }

    private static IOrderedEnumerable<FolderEntry> Sorted(List<FolderEntry> entries) =>
        entries.OrderBy(e => e.Name, StringComparer.OrdinalIgnoreCase).ThenBy(e => e.Name, StringComparer.Ordinal);

    private static string SizeOf(FileInfo file)
    {
        try
        {
            return file.Length switch
            {
                < 1_000 and var bytes => string.Create(CultureInfo.InvariantCulture, $"{bytes} B"),
                < 1_000_000 and var bytes => string.Create(CultureInfo.InvariantCulture, $"{bytes / BytesOfKilobyte:0.0} kB"),
                var bytes => string.Create(CultureInfo.InvariantCulture, $"{bytes / (BytesOfKilobyte * BytesOfKilobyte):#,##0.0} MB"),
            };
        }
        catch (IOException)
        {
            // A broken link, or just deleted: tapping it shows a message.
            return "";
        }
    }
}
