using System.Buffers;
using System.Buffers.Binary;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>One entry of the audit trail: who did what, when, on what basis. Its hash covers every field and the hash of the entry before
/// it.</summary>
/// <param name="Seq">Its number, counting from 1 without gaps.</param>
/// <param name="At">When, by the clock, to the microsecond. The order of entries is that of their numbers, whatever the clock says.</param>
/// <param name="Who">The user's name, or <c>cell</c> for what the cell does by its policy.</param>
/// <param name="What">What was done, in one word.</param>
/// <param name="Subject">What it was done to; null if nothing in particular.</param>
/// <param name="Basis">The basis.</param>
/// <param name="Previous">Hash of the previous entry; 64 zeros for the first.</param>
/// <param name="Hash">SHA-256 over all other fields, as 64 lowercase hexadecimal digits.</param>
public sealed record AuditEntry(
    long Seq, DateTimeOffset At, string Who, string What, Statement? Subject, Statement Basis, string Previous, string Hash)
{
    /// <summary>The user name for what the cell does by its policy.</summary>
    internal const string ByCell = "cell";

    /// <summary>The previous hash of the first entry.</summary>
    public const string NoHash = "0000000000000000000000000000000000000000000000000000000000000000";

    private const string Form = "errormatch audit 1";
    private const string FormWithRows = "errormatch audit 2";

    /// <summary>The rows of the store that the entry wrote, one per line: the row's code and its name. Null if it wrote none, and for
    /// entries of versions without row codes.</summary>
    public string? RowCodes { get; init; }

    /// <summary>Creates the entry that follows the one with the given hash.</summary>
    internal static AuditEntry After(string previous, long seq, DateTimeOffset at, string who, string what, Statement? subject,
        Statement basis,
        string? rowCodes = null)
    {
        var entry = new AuditEntry(seq, at, who, what, subject, basis, previous, "") { RowCodes = rowCodes };
        return entry with { Hash = entry.HashAs(seq) };
    }

    /// <summary>The correct hash of this entry if its number is <paramref name="seq"/>. The hashed bytes are unambiguous: the format's
    /// name, then number and time as 8 big-endian bytes each, then each text as its byte count (4 bytes, big-endian; -1 for null) and its
    /// UTF-8 bytes, in the order previous, who, what, subject, basis: the last two as they are recorded. An entry with row codes uses
    /// another format name, and the codes follow the basis.</summary>
    internal string HashAs(long seq)
    {
        Span<byte> hash = stackalloc byte[SHA256.HashSizeInBytes];
        WriteHash(seq, hash);
        return Convert.ToHexStringLower(hash);
    }

    /// <summary>True if the hash of this entry is the correct one for a number.</summary>
    internal bool IsWrittenAs(long seq)
    {
        Span<byte> hash = stackalloc byte[SHA256.HashSizeInBytes];
        WriteHash(seq, hash);
        Span<char> digits = stackalloc char[2 * SHA256.HashSizeInBytes];
        return Convert.TryToHexStringLower(hash, digits, out _) && digits.SequenceEqual(Hash);
    }

    private void WriteHash(long seq, Span<byte> hash)
    {
        var form = RowCodes is null ? Form : FormWithRows;
        ReadOnlySpan<string?> texts = [Previous, Who, What, Subject?.Text, Basis.Text, RowCodes];
        if (RowCodes is null) texts = texts[..^1];
        var most = form.Length + 16;
        foreach (var text in texts) most += 4 + Encoding.UTF8.GetMaxByteCount(text?.Length ?? 0);
        var bytes = ArrayPool<byte>.Shared.Rent(most);
        var at = Encoding.UTF8.GetBytes(form, bytes);
        BinaryPrimitives.WriteInt64BigEndian(bytes.AsSpan(at), seq);
        BinaryPrimitives.WriteInt64BigEndian(bytes.AsSpan(at + 8), StoredTime.Of(At));
        at += 16;
        foreach (var text in texts)
        {
            var length = text is null ? 0 : Encoding.UTF8.GetBytes(text, bytes.AsSpan(at + 4));
            BinaryPrimitives.WriteInt32BigEndian(bytes.AsSpan(at), text is null ? -1 : length);
            at += 4 + length;
        }

        SHA256.HashData(bytes.AsSpan(0, at), hash);
        ArrayPool<byte>.Shared.Return(bytes);
    }
}

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
