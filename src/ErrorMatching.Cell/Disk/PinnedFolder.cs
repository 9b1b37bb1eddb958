using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Cell;

/// <summary>A pinned folder that is not a link: operations by its path act on this very folder, even if its name now belongs to another.
/// Outside Linux the folder is only checked first.</summary>
internal sealed class PinnedFolder : IDisposable
{
    private readonly SafeFileHandle? _held;

    private PinnedFolder(string path, SafeFileHandle? held) => (Path, _held) = (path, held);

    /// <summary>The path for operations.</summary>
    public string Path { get; }

    /// <summary>Pins a folder.</summary>
    /// <returns>Null if nothing has this name.</returns>
    /// <exception cref="NotPlainFolderException">It is a link or a file.</exception>
    public static PinnedFolder? Open(string path)
    {
        if (!LinuxCalls.HasPaths)
        {
            var item = new DirectoryInfo(path);
            return item.LinkTarget is not null || File.Exists(path) ? throw new NotPlainFolderException(path)
                : item.Exists ? new(path, null) : null;
        }

        SafeFileHandle held;
        try
        {
            held = LinuxCalls.Hold(path);
        }
        catch (FileNotFoundException)
        {
            return null;
        }

        if (LinuxCalls.KindOf(held) == LinuxCalls.FolderKind)
        {
            return new(LinuxCalls.PathOf(held), held);
        }

        held.Dispose();
        throw new NotPlainFolderException(path);
    }

    public void Dispose() => _held?.Dispose();
}

/// <summary>The name of one of the cell's own folders belongs to a link or a file.</summary>
internal sealed class NotPlainFolderException(string path)
    : IOException($"{path} is a link or a file; it must be a folder of its own. Remove it");
