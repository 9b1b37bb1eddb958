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
    private readonly string _folder = Path.Combine(incoming, Name);
    private bool _isThere;

    /// <summary>The files in it, in order of time of change and name; none where the folder is not there.</summary>
    public IReadOnlyList<FileInfo> Files()
    {
        var folder = new DirectoryInfo(_folder);
        return folder.Exists ? [.. folder.EnumerateFiles("*", new EnumerationOptions { AttributesToSkip = FileAttributes.None, IgnoreInaccessible = false }).OrderBy(f => f.LastWriteTimeUtc).ThenBy(f => f.Name, StringComparer.Ordinal)] : [];
    }

    /// <summary>Moves a file here; null if it cannot be moved yet, or another of its name is still here.</summary>
    public FileInfo? Claim(string name)
    {
        Ensure();
        var (from, to) = (Path.Combine(incoming, name), Path.Combine(_folder, name));
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
            _isThere = false;
            return null;
        }
    }

    /// <summary>True if a file of this name is here.</summary>
    public bool Has(string name) => File.Exists(Path.Combine(_folder, name));

    /// <summary>Removes a file of this folder; none of this name is no error.</summary>
    /// <returns>False if something still has it open; the next look sees it again.</returns>
    public bool Remove(string name)
    {
        try
        {
            File.Delete(Path.Combine(_folder, name));
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    /// <summary>Lays a file aside that is kept nowhere else, under its hash.</summary>
    public void LayAside(FileInfo file, string sha256)
    {
        var folder = Directory.CreateDirectory(Path.Combine(_folder, TooLarge));
        File.Move(file.FullName, Path.Combine(folder.FullName, sha256), overwrite: true);
    }

    private void Ensure()
    {
        if (_isThere)
        {
            return;
        }

        var folder = Directory.CreateDirectory(_folder);
        if (folder.Attributes.HasFlag(FileAttributes.ReparsePoint))
        {
            throw new IOException($"{_folder} is a link; it must be a folder of its own");
        }

        _isThere = true;
    }
}
