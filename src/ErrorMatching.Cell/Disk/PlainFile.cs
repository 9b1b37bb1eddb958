using ErrorMatching.Json;
using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Cell;

/// <summary>Distinguishes plain files from everything else, and opens only plain files: opening a pipe or a device could block forever, and
/// a link may lead anywhere.</summary>
internal static class PlainFile
{
    private const string Link = "it is a link";
    private const string Folder = "it is a folder";
    private const string Other = "it is a pipe, a socket or a device";

    /// <summary>Why something is not a plain file; null if it is one.</summary>
    public static string? Defect(FileSystemInfo item)
    {
        var attributes = item.Attributes;
        if (attributes.HasFlag(FileAttributes.ReparsePoint))
        {
            return Link;
        }

        if (attributes.HasFlag(FileAttributes.Directory))
        {
            return Folder;
        }

        // The runtime does not tell a file's type before it is opened. A name that cannot be encoded has no type, and opening it just
        // fails.
        return attributes.HasFlag(FileAttributes.Device)
            || (OperatingSystem.IsLinux() && LinuxCalls.KindOf(item.FullName) is not (null or LinuxCalls.PlainKind)) ? Other : null;
    }

    /// <summary>Opens a plain file for reading. On Linux the file that is checked is the file that is opened, even if its name changes
    /// owner in between.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="share">What other processes may do with it meanwhile.</param>
    /// <exception cref="NotPlainFileException">It is a link, a folder, a pipe, a socket or a device.</exception>
    public static SafeFileHandle Open(string path, FileShare share)
    {
        if (!LinuxCalls.HasPaths)
        {
            // Opening reports a missing file.
            var item = new FileInfo(path);
            return (item.Exists || Directory.Exists(path)) && Defect(item) is { } defect ? throw new NotPlainFileException(path, defect)
                : SharedFile.OpenHandle(path, share);
        }

        using var held = LinuxCalls.Hold(path);
        switch (LinuxCalls.KindOf(held))
        {
            case LinuxCalls.PlainKind:
                break;
            case LinuxCalls.LinkKind:
                throw new NotPlainFileException(path, Link);
            case LinuxCalls.FolderKind:
                throw new NotPlainFileException(path, Folder);
            default:
                throw new NotPlainFileException(path, Other);
        }

        var place = LinuxCalls.PathOf(held);
        try
        {
            return SharedFile.OpenHandle(place, share);
        }
        catch (UnauthorizedAccessException e)
        {
            throw new UnauthorizedAccessException(e.Message.Replace(place, path, StringComparison.Ordinal), e);
        }
        catch (IOException e)
        {
            // People know it by its name.
            throw new IOException(e.Message.Replace(place, path, StringComparison.Ordinal), e.HResult);
        }
    }
}

/// <summary>A path leads to something other than a plain file: a link, a folder, a pipe, a socket or a device.</summary>
/// <param name="path">Its path.</param>
/// <param name="defect">What it is, as returned by <see cref="PlainFile.Defect"/>.</param>
internal sealed class NotPlainFileException(string path, string defect) : IOException($"{path} is no plain file: {defect}")
{
    /// <summary>What it is.</summary>
    public string Defect => defect;
}
