using System.Xml;
using System.Xml.Linq;
using ErrorMatching.Json;
using Microsoft.AspNetCore.DataProtection.Repositories;

namespace ErrorMatching.Cell;

/// <summary>The key folder; only its owner can read it or anything in it. DataProtection stores its keys here too, because the framework's
/// own repository would leave their permissions to the umask.</summary>
internal sealed class KeyFolder : IXmlRepository
{
    private const UnixFileMode Others = UnixFileMode.GroupRead | UnixFileMode.GroupWrite | UnixFileMode.GroupExecute
        | UnixFileMode.OtherRead | UnixFileMode.OtherWrite | UnixFileMode.OtherExecute;

    // ENOSPC on Linux; ERROR_DISK_FULL and ERROR_HANDLE_DISK_FULL on Windows.
    private const int NoSpace = 28;
    private const int WindowsDiskFull = unchecked((int)0x80070070);
    private const int WindowsHandleDiskFull = unchecked((int)0x80070027);

    private readonly string _folder;

    /// <summary>Opens a key folder; creates it if it is missing.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public KeyFolder(string folder)
    {
        _folder = folder;
        Try("made", folder, () => Own(folder));
    }

    public IReadOnlyCollection<XElement> GetAllElements() =>
        [
            .. Try(
                "listed",
                _folder,
                () => Directory.EnumerateFiles(_folder, "*.xml").Order(StringComparer.Ordinal).ToArray())
                .Select(f => Try("read", f, () => Element(f)))];

    public void StoreElement(XElement element, string friendlyName)
    {
        using var text = new MemoryStream();
        element.Save(text);
        Write($"key-{Guid.NewGuid():D}.xml", text.ToArray(), overwrite: false);
    }

    /// <summary>The bytes of a file.</summary>
    public byte[] Read(string name) => Try("read", Path.Combine(_folder, name), () => SharedFile.ReadAllBytes(Path.Combine(_folder, name)));

    /// <summary>Writes a complete file and flushes it to disk.</summary>
    /// <returns>False if the name is taken and must not be overwritten.</returns>
    public bool Write(string name, byte[] bytes, bool overwrite) => Try("written", Path.Combine(_folder, name), () =>
    {
        var (file, beside) = (Path.Combine(_folder, name), Path.Combine(_folder, $"{name}.{Guid.NewGuid():N}.new"));
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows())
        {
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        }

        try
        {
            using (var stream = new FileStream(beside, options))
            {
                stream.Write(bytes);
                stream.Flush(flushToDisk: true);
            }

            if (!overwrite)
            {
                return FirstFile.TryPut(beside, file);
            }

            SharedFile.Replace(beside, file);
            return true;
        }
        finally
        {
            File.Delete(beside);
        }
    });

    private static XElement Element(string file)
    {
        using var stream = SharedFile.OpenRead(file);
        return XElement.Load(stream);
    }

    private static DirectoryInfo Own(string folder)
    {
        if (OperatingSystem.IsWindows())
        {
            return Directory.CreateDirectory(folder);
        }

        var made = Directory.CreateDirectory(folder, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        foreach (var path in Directory.EnumerateFiles(folder).Prepend(folder))
        {
            if (ModeOf(path) is { } mode && (mode & Others) != UnixFileMode.None)
            {
                throw new PeopleException(
                    PeopleError.KeysUnusable,
                    $"Others than its owner can reach {path}, which guards the passwords of machines and the audit trail. If you are "
                        + $"sure that nobody did: chmod go-rwx {path}. Else set the machines' passwords anew as well.");
            }
        }

        return made;
    }

    // A file that another process was just writing has its final name by now.
    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    private static UnixFileMode? ModeOf(string path)
    {
        try
        {
            return File.GetUnixFileMode(path);
        }
        catch (FileNotFoundException)
        {
            return null;
        }
    }

    private static T Try<T>(string done, string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or XmlException)
        {
            throw new PeopleException(PeopleError.KeysUnusable, $"{path} cannot be {done}: {e.Message.TrimEnd('.')}. {WhatToDo(e)}", e);
        }
    }

    private static string WhatToDo(Exception e) => e switch
    {
        IOException { HResult: NoSpace or WindowsDiskFull or WindowsHandleDiskFull } => "Make room on its disk, then repeat what failed.",
        XmlException => "Bring the keys back from a backup.",
        _ => "The keys belong to the account that the cell runs under; use that account, or bring them back from a backup.",
    };
}
