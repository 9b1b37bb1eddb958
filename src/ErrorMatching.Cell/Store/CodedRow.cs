using System.Buffers.Binary;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A row that carries a code: HMAC-SHA-256 by the key of the audit trail over which row it is and everything in it. Who writes to
/// the store without the key cannot make one.</summary>
/// <param name="Name">Which row, such as <c>correction 5</c>; no other row of the store has this name, which is one line.</param>
/// <param name="Values">What is in it.</param>
internal sealed record CodedRow(string Name, IReadOnlyList<string?> Values)
{
    private const string Form = "errormatch row 1";
    private const int CodeLength = 64;

    /// <summary>The code, as 64 lower-case hexadecimal digits. What is hashed cannot be read in two ways: the form's name, then name and
    /// values, each as the count of its bytes (4 bytes, the highest first; -1 for none) and these in UTF-8.</summary>
    public string Code(ReadOnlySpan<byte> key)
    {
        using var hash = IncrementalHash.CreateHMAC(HashAlgorithmName.SHA256, key);
        Span<byte> count = stackalloc byte[4];
        hash.AppendData(Encoding.UTF8.GetBytes(Form));
        foreach (var text in Values.Prepend(Name))
        {
            var bytes = text is null ? null : Encoding.UTF8.GetBytes(text);
            BinaryPrimitives.WriteInt32BigEndian(count, bytes?.Length ?? -1);
            hash.AppendData(count);
            hash.AppendData(bytes.AsSpan());
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    /// <summary>A number as a value.</summary>
    public static string Number(long number) => number.ToString(CultureInfo.InvariantCulture);

    /// <summary>A number as a value; null for none.</summary>
    public static string? Number(double? number) => number?.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>A number as a value; null for none.</summary>
    public static string? Number(long? number) => number is { } some ? Number(some) : null;

    /// <summary>Codes as an audit entry names them: one a line, the code and the row's name.</summary>
    public static string Lines(IEnumerable<(string Name, string Code)> rows) => string.Join('\n', rows.Select(r => $"{r.Code} {r.Name}"));

    /// <summary>Reads what <see cref="Lines"/> wrote; a line that is none is left out.</summary>
    public static IEnumerable<(string Name, string Code)> Read(string lines) =>
        lines.Split('\n').Where(l => l.Length > CodeLength + 1 && l[CodeLength] == ' ')
            .Select(l => (l[(CodeLength + 1)..], l[..CodeLength]));
}
