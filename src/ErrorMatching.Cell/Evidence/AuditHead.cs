using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Where the audit trail ends, kept apart from it: so a removed end is found.</summary>
/// <param name="Seq">Number of the last entry; 0 if there is none.</param>
/// <param name="At">Its time.</param>
/// <param name="Hash">Its hash; <see cref="AuditEntry.NoHash"/> if there is none.</param>
/// <param name="Seal">HMAC-SHA-256 over number and hash, by a key that is not in the store; null if it was written without a key.</param>
public sealed record AuditHead(long Seq, DateTimeOffset At, string Hash, string? Seal)
{
    /// <summary>The seal that a key gives to a head, as 64 lower-case hexadecimal digits.</summary>
    internal static string SealOf(ReadOnlySpan<byte> key, long seq, string hash) =>
        Convert.ToHexStringLower(HMACSHA256.HashData(key, Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture, $"errormatch audit head 1\n{seq}\n{hash}"))));

    /// <summary>True if the seal is the key's.</summary>
    internal bool IsSealedBy(ReadOnlySpan<byte> key) =>
        Seal is not null && CryptographicOperations.FixedTimeEquals(Encoding.UTF8.GetBytes(Seal), Encoding.UTF8.GetBytes(SealOf(key, Seq, Hash)));

    /// <summary>
    /// The head that follows with one more entry. A seal that is not the key's is not made good by the next entry: it stays as it is, and with it the finding.
    /// </summary>
    /// <param name="entry">The entry.</param>
    /// <param name="key">The key that seals; null for none.</param>
    /// <param name="begins">True for the entry that a store begins with, before which there is no seal.</param>
    internal AuditHead With(AuditEntry entry, byte[]? key, bool begins) =>
        new(entry.Seq, entry.At, entry.Hash, key is null ? null : begins || IsSealedBy(key) ? SealOf(key, entry.Seq, entry.Hash) : Seal);
}
