using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The end of the audit trail, stored separately so that a cut-off end is detected.</summary>
/// <param name="Seq">Number of the last entry; 0 if there is none.</param>
/// <param name="At">Its time.</param>
/// <param name="Hash">Its hash; <see cref="AuditEntry.NoHash"/> if there is none.</param>
/// <param name="Seal">HMAC-SHA-256 over number and hash, with a key that is not in the store; null if written without a key.</param>
public sealed record AuditHead(long Seq, DateTimeOffset At, string Hash, string? Seal)
{
    /// <summary>The seal of a head by a key, as 64 lowercase hexadecimal digits.</summary>
    internal static string SealOf(ReadOnlySpan<byte> key, long seq, string hash) =>
        Convert.ToHexStringLower(HMACSHA256.HashData(
            key, Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture, $"errormatch audit head 1\n{seq}\n{hash}"))));

    /// <summary>True if the seal was made with the key.</summary>
    internal bool IsSealedBy(ReadOnlySpan<byte> key) =>
        Seal is not null
            && CryptographicOperations.FixedTimeEquals(Encoding.UTF8.GetBytes(Seal), Encoding.UTF8.GetBytes(SealOf(key, Seq, Hash)));

    /// <summary>The head after one more entry. An invalid seal is not repaired by the next entry: it stays as it is, so the fault remains
    /// detectable.</summary>
    /// <param name="entry">The entry.</param>
    /// <param name="key">The sealing key; null for none.</param>
    /// <param name="begins">True for the first entry of a store, before which there is no seal.</param>
    internal AuditHead With(AuditEntry entry, byte[]? key, bool begins) =>
        new(entry.Seq, entry.At, entry.Hash, key is null ? null : begins || IsSealedBy(key) ? SealOf(key, entry.Seq, entry.Hash) : Seal);
}
