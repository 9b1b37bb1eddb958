using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>The key that seals the end of the audit trail: random, kept in the folder of the keys and encrypted by them. Cells that share a store share the folder's content.</summary>
public static class AuditKey
{
    private const string FileName = "audit.key";
    private const int Bytes = 32;
    private static readonly string[] Purposes = ["seal of the audit trail"];

    /// <summary>The key of a cell; made if its store is not there yet. A new key for an old store would prove nothing of it.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysMissing"/> if the store was sealed by a key that is not there; else as of <see cref="Open"/>.</exception>
    /// <exception cref="StoreException">Whether the store was sealed cannot be read.</exception>
    public static byte[] OpenFor(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);

        // Another process may be making both just now: the key comes first.
        return Find(settings.KeysFolder) ?? (!CellStore.IsSealed(settings.Store) ? Open(settings.KeysFolder) : Find(settings.KeysFolder))
            ?? throw new PeopleException(PeopleError.KeysMissing, Missing(settings.KeysFolder));
    }

    /// <summary>Says that the key is not there.</summary>
    internal static string Missing(string keysFolder) =>
        $"{Path.Combine(keysFolder, FileName)} is not there, and it sealed the audit trail: whether the trail's end was cut off, or all of it written again, cannot be said. Bring the folder of the keys back from a backup.";

    /// <summary>The key; made if there is none yet.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/> or <see cref="PeopleError.SecretUnreadable"/>.</exception>
    public static byte[] Open(string keysFolder)
    {
        if (Find(keysFolder) is { } key)
        {
            return key;
        }

        // With the key begins what is known of the trail: later, a missing witness is a fault.
        var keys = new KeyRing(keysFolder);
        AuditWitness.Begin(keysFolder);
        keys.WriteNew(FileName, keys.Protect(Purposes, Convert.ToBase64String(RandomNumberGenerator.GetBytes(Bytes))));

        // Another process may have been faster: what counts is what the file says.
        return Find(keysFolder)!;
    }

    /// <summary>The key; null if there is none.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/> or <see cref="PeopleError.SecretUnreadable"/>.</exception>
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
}
