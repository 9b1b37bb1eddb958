namespace ErrorMatching.Cell;

/// <summary>
/// The folder inside an incoming folder that a file is moved to before it is read. What a gauge writes under the same name meanwhile is another file, and cannot be removed unread; what a kill leaves here is
/// taken up again.
/// </summary>
internal sealed class ClaimFolder(string incoming)
{
    /// <summary>Its name.</summary>
    public const string Name = ".errormatch";

    private const string TooLarge = "too-large";
    private static readonly EnumerationOptions All = new() { AttributesToSkip = FileAttributes.None, IgnoreInaccessible = false };
    private readonly string _folder = Path.Combine(incoming, Name);
    private PinnedFolder? _pinned;

    /// <summary>Takes hold of the folder for one look: until its end everything is done in that very folder. No longer, or its share could
    /// not be unmounted.</summary>
    /// <exception cref="NotPlainFolderException">A link has its name: files elsewhere would be archived and deleted.</exception>
    public void Begin() => _pinned = PinnedFolder.Open(_folder);

    /// <summary>Lets go of it.</summary>
    public void End()
    {
        _pinned?.Dispose();
        _pinned = null;
    }

    /// <summary>The files in it, in order of time of change and name; none where the folder is not there.</summary>
    public IReadOnlyList<FileInfo> Files() => _pinned is not { } folder
        ? []
        : [.. new DirectoryInfo(folder.Path).EnumerateFiles("*", All).OrderBy(f => f.LastWriteTimeUtc).ThenBy(f => f.Name,
            StringComparer.Ordinal)];

    /// <summary>Moves a file here; null if it cannot be moved yet, or another of its name is still here.</summary>
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
            // Its writer still has it, or has just replaced or withdrawn it; or this folder is gone, and is made again next time.
            return null;
        }
    }

    /// <summary>True if a file of this name is here.</summary>
    public bool Has(string name) => _pinned is { } folder && File.Exists(Path.Combine(folder.Path, name));

    /// <summary>Removes a file of this folder; none of this name is no error.</summary>
    /// <returns>False if something still has it open; the next look sees it again.</returns>
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

    /// <summary>Lays a file of this folder aside that is kept nowhere else, under its hash.</summary>
    public void LayAside(FileInfo file, string sha256)
    {
        _pinned ??= Made(_folder);
        using var folder = Made(Path.Combine(_pinned.Path, TooLarge));
        File.Move(file.FullName, Path.Combine(folder.Path, sha256), overwrite: true);
    }

    private static PinnedFolder Made(string folder)
    {
        Directory.CreateDirectory(folder);
        return PinnedFolder.Open(folder) ?? throw new DirectoryNotFoundException($"{folder} was made and is not there");
    }
}
