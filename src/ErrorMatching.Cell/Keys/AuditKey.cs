using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>The key that seals the end of the audit trail: random, stored in the key folder and encrypted with its keys. Cells that share a
/// store share the content of that folder.</summary>
public static class AuditKey
{
    private const string FileName = "audit.key";
    private const int Bytes = 32;
    private static readonly string[] Purposes = ["seal of the audit trail"];

    /// <summary>The key of a cell; created if its store does not exist yet. A new key for an old store would prove nothing about
    /// it.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysMissing"/> if the key that sealed the store is missing; otherwise
    /// as for <see cref="Open"/>.</exception>
    /// <exception cref="StoreException">The store cannot be read to find out whether it is sealed.</exception>
    public static byte[] OpenFor(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);

        // Another process may be creating both at this moment: the key comes first.
        return Find(settings.KeysFolder) ?? (!StoreOpening.IsSealed(settings.Store) ? Open(settings.KeysFolder) : Find(settings.KeysFolder))
            ?? throw new PeopleException(PeopleError.KeysMissing, Missing(settings.KeysFolder));
    }

    /// <summary>The message that the key is missing, or that this account may not see it.</summary>
    internal static string Missing(string keysFolder)
    {
        const string Unknown =
            "it sealed the audit trail: whether the trail's end was cut off, or all of it written again, cannot be said.";
        var file = Path.Combine(keysFolder, FileName);
        return IsClosed(keysFolder)
            ? $"This account may not read {file}, and {Unknown} Run this with the cell's account."
            : $"{file} is not there, and {Unknown} Bring the folder of the keys back from a backup.";
    }

    /// <summary>The key; created if there is none yet.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/> or
    /// <see cref="PeopleError.SecretUnreadable"/>.</exception>
    public static byte[] Open(string keysFolder)
    {
        if (Find(keysFolder) is { } key)
        {
            return key;
        }

        // The record of the trail starts with the key: from then on, a missing witness is a fault.
        var keys = new KeyRing(keysFolder);
        AuditWitness.Begin(keysFolder);
        keys.WriteNew(FileName, keys.Protect(Purposes, Convert.ToBase64String(RandomNumberGenerator.GetBytes(Bytes))));

        // Another process may have been faster, so read the key from the file.
        return Find(keysFolder)!;
    }

    /// <summary>The key; null if there is none.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/> or
    /// <see cref="PeopleError.SecretUnreadable"/>.</exception>
    public static byte[]? Find(string keysFolder)
    {
        var file = Path.Combine(keysFolder, FileName);
        if (!File.Exists(file))
        {
            return null;
        }

        var keys = new KeyRing(keysFolder);
        return Convert.FromBase64String(keys.Unprotect(Purposes, keys.Read(FileName), file));
    }

    // To an account without rights, a file in a closed folder looks as if it were missing.
    private static bool IsClosed(string folder)
    {
        try
        {
            _ = Directory.EnumerateFileSystemEntries(folder).FirstOrDefault();
            return false;
        }
        catch (UnauthorizedAccessException)
        {
            return true;
        }
        catch (IOException)
        {
            return false;
        }
    }
}
