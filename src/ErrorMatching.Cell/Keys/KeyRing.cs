using System.Security.Cryptography;
using System.Text;
using Microsoft.AspNetCore.DataProtection;
using Microsoft.AspNetCore.DataProtection.KeyManagement;
using Microsoft.Extensions.DependencyInjection;

namespace ErrorMatching.Cell;

/// <summary>Encrypts data that only this installation may read, with ASP.NET's DataProtection. Encryption is authenticated: data that was
/// changed, moved to another purpose or encrypted elsewhere is detected. On Windows, DPAPI encrypts the keys for this computer, since
/// services and tasks run under other accounts than the one that sets passwords; elsewhere only the owner can read the key files.</summary>
internal sealed class KeyRing
{
    private readonly IDataProtectionProvider _provider;
    private readonly KeyFolder _files;
    private readonly string _folder;

    /// <summary>Opens the keys in a folder; creates the folder and a first key if it is missing.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public KeyRing(string folder)
    {
        _folder = folder;
        _files = new KeyFolder(folder);
        _provider = DataProtectionProvider.Create(new DirectoryInfo(folder), builder =>
        {
            builder.SetApplicationName("errormatch cell");
            if (OperatingSystem.IsWindows())
            {
                builder.ProtectKeysWithDpapi(protectToLocalMachine: true);
            }

            builder.Services.Configure<KeyManagementOptions>(options => options.XmlRepository = _files);
        });
    }

    /// <summary>Encrypts a text.</summary>
    /// <param name="purposes">Its purpose; the text cannot be decrypted for another one.</param>
    /// <param name="text">The text.</param>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public byte[] Protect(IReadOnlyList<string> purposes, string text)
    {
        try
        {
            return _provider.CreateProtector(purposes).Protect(Encoding.UTF8.GetBytes(text));
        }
        catch (CryptographicException e)
        {
            throw OfFolder(e)
                ?? new PeopleException(
                    PeopleError.KeysUnusable,
                    $"The keys in {_folder} do not encrypt any more: somebody changed them. Bring them back from a backup.",
                    e);
        }
    }

    /// <summary>Decrypts a text.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.SecretUnreadable"/> if these keys did not encrypt it for this purpose,
    /// or if it was changed.</exception>
    public string Unprotect(IReadOnlyList<string> purposes, byte[] bytes, string what)
    {
        try
        {
            return Encoding.UTF8.GetString(_provider.CreateProtector(purposes).Unprotect(bytes));
        }
        catch (CryptographicException e)
        {
            throw OfFolder(e) ?? new PeopleException(
                PeopleError.SecretUnreadable,
                $"{what} is not what the keys in {_folder} encrypted: they are the keys of another installation, or somebody changed "
                    + $"them or the store. Bring back the keys that belong to the store, or set it again.",
                e);
        }
    }

    // The folder's own exception, which the framework wraps.
    private static PeopleException? OfFolder(Exception? e)
    {
        while (e is not null and not PeopleException)
        {
            e = e.InnerException;
        }

        return (PeopleException?)e;
    }

    /// <summary>The bytes of another file in the folder.</summary>
    public byte[] Read(string name) => _files.Read(name);

    /// <summary>Writes another file in the folder, unless the name is taken.</summary>
    public void WriteNew(string name, byte[] bytes) => _files.Write(name, bytes, overwrite: false);
}
