using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>One entry of the audit trail: who did what, when, on what basis. Its hash covers every field and the hash of the entry before it.</summary>
/// <param name="Seq">Its number; the first is 1 and none is left out.</param>
/// <param name="At">When, as the clock said, to the microsecond. The order of entries is that of their numbers, whatever a clock says.</param>
/// <param name="Who">The user's name, or <c>cell</c> for what the cell does by its policy.</param>
/// <param name="What">What was done, in one word.</param>
/// <param name="Subject">What it was done to; null if it was to nothing in particular.</param>
/// <param name="Basis">On what basis, in words.</param>
/// <param name="Previous">Hash of the entry before; 64 zeros for the first.</param>
/// <param name="Hash">SHA-256 over all of that, as 64 lower-case hexadecimal digits.</param>
public sealed record AuditEntry(long Seq, DateTimeOffset At, string Who, string What, string? Subject, string Basis, string Previous, string Hash)
{
    /// <summary>What the first entry has instead of the hash of an entry before it.</summary>
    public const string NoHash = "0000000000000000000000000000000000000000000000000000000000000000";

    private const string Form = "errormatch audit 1";
    private const string FormWithRows = "errormatch audit 2";

    /// <summary>The rows of the store that it leaves, one a line: the row's code and its name. Null if it leaves none, and for entries of
    /// versions that gave rows no codes.</summary>
    public string? RowCodes { get; init; }

    /// <summary>Makes the entry that follows one whose hash is given.</summary>
    internal static AuditEntry After(string previous, long seq, DateTimeOffset at, string who, string what, string? subject, string basis,
        string? rowCodes = null)
    {
        var entry = new AuditEntry(seq, at, who, what, subject, basis, previous, "") { RowCodes = rowCodes };
        return entry with { Hash = entry.HashAs(seq) };
    }

    /// <summary>
    /// The hash that this entry has to have if its number is <paramref name="seq"/>. What is hashed cannot be read in two ways: the form's name, number and time as 8 bytes each with the highest first,
    /// then each text as the count of its bytes (4 bytes, the highest first; -1 for none) and these in UTF-8, in the order previous, who,
    /// what, subject, basis. An entry that leaves rows has another form's name, and their codes behind the basis.
    /// </summary>
    internal string HashAs(long seq)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Span<byte> number = stackalloc byte[8];
        hash.AppendData(Encoding.UTF8.GetBytes(RowCodes is null ? Form : FormWithRows));
        BinaryPrimitives.WriteInt64BigEndian(number, seq);
        hash.AppendData(number);
        BinaryPrimitives.WriteInt64BigEndian(number, StoredTime.Of(At));
        hash.AppendData(number);
        foreach (var text in (string?[])[Previous, Who, What, Subject, Basis, .. RowCodes is null ? Array.Empty<string>() : [RowCodes]])
        {
            var bytes = text is null ? null : Encoding.UTF8.GetBytes(text);
            BinaryPrimitives.WriteInt32BigEndian(number, bytes?.Length ?? -1);
            hash.AppendData(number[..4]);
            hash.AppendData(bytes.AsSpan());
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }
}
