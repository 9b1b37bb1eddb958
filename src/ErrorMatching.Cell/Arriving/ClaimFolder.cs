using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The claim folder inside an incoming folder: files are moved here before they are read. A file that a gauge then writes under
/// the same name is separate and cannot be deleted unread. Files that a killed process left here are processed later.</summary>
internal sealed class ClaimFolder(string incoming)
{
    public const string Name = ".errormatch";

    private const string TooLarge = "too-large";
    private static readonly EnumerationOptions All = new() { AttributesToSkip = FileAttributes.None, IgnoreInaccessible = false };
    private readonly string _folder = Path.Combine(incoming, Name);
    private PinnedFolder? _pinned;

    /// <summary>Pins the folder for one look, so that all operations act on this very folder. It is not held longer, because that would
    /// block unmounting its share.</summary>
    /// <exception cref="NotPlainFolderException">The name is a link: files elsewhere would be archived and deleted.</exception>
    public void Begin() => _pinned = PinnedFolder.Open(_folder);

    /// <summary>Releases the folder.</summary>
    public void End()
    {
        _pinned?.Dispose();
        _pinned = null;
    }

    /// <summary>The files in it, ordered by modification time and name; none if the folder does not exist.</summary>
    public IReadOnlyList<FileInfo> Files() => _pinned is not { } folder
        ? []
        : [.. new DirectoryInfo(folder.Path).EnumerateFiles("*", All).OrderBy(f => f.LastWriteTimeUtc).ThenBy(f => f.Name,
            StringComparer.Ordinal)];

    /// <summary>Moves a file here; null if it cannot be moved yet, or if another file of that name is still here.</summary>
    public FileInfo? Claim(string name)
    {
        _pinned ??= Made(_folder);
        var (from, to) = (Path.Combine(incoming, name), Path.Combine(_pinned.Path, name));
        try
        {
            if (File.Exists(to))
            {
                return null;
            }

            File.Move(from, to);
            return new(to);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The writer still has it open, or has just replaced or withdrawn it. Or this folder is gone; the next look creates it again.
            return null;
        }
    }

    /// <summary>True if a file of this name is here.</summary>
    public bool Has(string name) => _pinned is { } folder && File.Exists(Path.Combine(folder.Path, name));

    /// <summary>Removes a file from this folder; succeeds if there is none of this name.</summary>
    /// <returns>False if the file is still open elsewhere; the next look sees it again.</returns>
    public bool Remove(string name)
    {
        try
        {
            if (_pinned is { } folder)
            {
                File.Delete(Path.Combine(folder.Path, name));
            }

            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    /// <summary>Sets aside a file of this folder that is stored nowhere else, named by its hash.</summary>
    public void LayAside(FileInfo file, string sha256)
    {
        _pinned ??= Made(_folder);
        using var folder = Made(Path.Combine(_pinned.Path, TooLarge));
        SharedFile.Replace(file.FullName, Path.Combine(folder.Path, sha256));
    }

    private static PinnedFolder Made(string folder)
    {
        Directory.CreateDirectory(folder);
        return PinnedFolder.Open(folder) ?? throw new DirectoryNotFoundException($"{folder} was made and is not there");
    }
}
