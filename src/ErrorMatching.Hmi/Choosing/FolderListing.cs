using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>What is in a folder: folders first, then files, each by name.</summary>
/// <param name="Folder">Its full path.</param>
/// <param name="Entries">What is shown of it.</param>
/// <param name="Hidden">How many hidden folders and files are not shown.</param>
/// <param name="Others">How many files are not shown because they end otherwise.</param>
/// <param name="IsWhole">False if there is more than was looked at.</param>
internal sealed record FolderListing(string Folder, IReadOnlyList<FolderEntry> Entries, int Hidden, int Others, bool IsWhole)
{
    /// <summary>No folder that people look through is larger; one that is, is told.</summary>
    public const int Most = 10_000;

    private const double BytesOfKilobyte = 1000;

    /// <summary>Looks into a folder. To be called beside the screen: shares take their time.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="extensions">The endings of files that are shown, each with its dot; none for all files; null for folders alone.</param>
    /// <param name="clock">For the zone of times.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="IOException">It is not there or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
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
            else if (extensions is null || (extensions.Count > 0 && !extensions.Contains(found.Extension, StringComparer.OrdinalIgnoreCase)))
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

    private static IOrderedEnumerable<FolderEntry> Sorted(List<FolderEntry> entries) => entries.OrderBy(e => e.Name, StringComparer.OrdinalIgnoreCase).ThenBy(e => e.Name, StringComparer.Ordinal);

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
            // A link to nothing, or gone at this moment: whoever taps on it is told.
            return "";
        }
    }
}
