using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using Microsoft.AspNetCore.DataProtection.Repositories;

namespace ErrorMatching.Cell;

/// <summary>The keys of DataProtection as files that only their owner can read. The framework's own repository leaves their rights to the umask.</summary>
internal sealed class KeyFiles : IXmlRepository
{
    private const UnixFileMode Others = UnixFileMode.GroupRead | UnixFileMode.GroupWrite | UnixFileMode.GroupExecute | UnixFileMode.OtherRead | UnixFileMode.OtherWrite | UnixFileMode.OtherExecute;

    private readonly string _folder;

    /// <summary>The keys of a folder, which is made if it is missing.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public KeyFiles(string folder)
    {
        _folder = folder;
        Try("made", folder, () =>
        {
            if (OperatingSystem.IsWindows())
            {
                return Directory.CreateDirectory(folder);
            }

            var made = Directory.CreateDirectory(folder, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            foreach (var path in Directory.EnumerateFiles(folder, "*.xml").Prepend(folder))
            {
                if ((File.GetUnixFileMode(path) & Others) != 0)
                {
                    throw new PeopleException(PeopleError.KeysUnusable, $"Others than its owner can read {path}, which encrypts the passwords of machines. If nobody has: chmod go-rwx {path}. Else remove it, and set the passwords again with errormatch cell secret.");
                }
            }

            return made;
        });
    }

    /// <inheritdoc/>
    public IReadOnlyCollection<XElement> GetAllElements() =>
        [.. Try("listed", _folder, () => Directory.EnumerateFiles(_folder, "*.xml").Order(StringComparer.Ordinal).ToArray()).Select(f => Try("read", f, () => XElement.Load(f)))];

    /// <inheritdoc/>
    public void StoreElement(XElement element, string friendlyName)
    {
        var file = Path.Combine(_folder, string.Create(CultureInfo.InvariantCulture, $"key-{Guid.NewGuid():D}.xml"));
        Try("written", file, () =>
        {
            var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write };
            if (!OperatingSystem.IsWindows())
            {
                options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
            }

            using (var stream = new FileStream(file + ".new", options))
            {
                element.Save(stream);
                stream.Flush(flushToDisk: true);
            }

            File.Move(file + ".new", file);
            return file;
        });
    }

    private static T Try<T>(string done, string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or XmlException)
        {
            throw new PeopleException(PeopleError.KeysUnusable, $"The keys at {path} cannot be {done}: {e.Message} Without them the passwords of machines cannot be read: bring them back from a backup, or set the passwords again with errormatch cell secret.", e);
        }
    }
}
