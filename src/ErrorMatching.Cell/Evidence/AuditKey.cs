using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>The key that seals the end of the audit trail: random, kept in the folder of the keys and encrypted by them. Cells that share a store share the folder's content.</summary>
public static class AuditKey
{
    private const string FileName = "audit.key";
    private const int Bytes = 32;
    private static readonly string[] Purposes = ["seal of the audit trail"];

    /// <summary>The key; made if there is none yet.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/> or <see cref="PeopleError.SecretUnreadable"/>.</exception>
    public static byte[] Open(string keysFolder)
    {
        if (Find(keysFolder) is { } key)
        {
            return key;
        }

        var keys = new KeyRing(keysFolder);
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
