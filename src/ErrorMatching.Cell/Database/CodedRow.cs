using System.Buffers;
using System.Buffers.Binary;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A row with a code: an HMAC-SHA-256, by the audit trail's key, over the row's identity and all its values. A writer without the
/// key cannot produce one.</summary>
/// <param name="Name">The row's identity, such as <c>correction 5</c>: one line, unique in the store.</param>
/// <param name="Values">Its values.</param>
internal sealed record CodedRow(string Name, IReadOnlyList<string?> Values)
{
    private const string Form = "errormatch row 1";
    private const int CodeLength = 64;

    /// <summary>The code, as 64 lowercase hexadecimal digits. The hashed bytes are unambiguous: the format's name, then name and values,
    /// each as its byte count (4 bytes, big-endian; -1 for null) and its UTF-8 bytes.</summary>
    public string Code(ReadOnlySpan<byte> key)
    {
        var most = Form.Length;
        foreach (var text in Values.Prepend(Name)) most += 4 + Encoding.UTF8.GetMaxByteCount(text?.Length ?? 0);
        var bytes = ArrayPool<byte>.Shared.Rent(most);
        var at = Encoding.UTF8.GetBytes(Form, bytes);
        foreach (var text in Values.Prepend(Name))
        {
            var length = text is null ? 0 : Encoding.UTF8.GetBytes(text, bytes.AsSpan(at + 4));
            BinaryPrimitives.WriteInt32BigEndian(bytes.AsSpan(at), text is null ? -1 : length);
            at += 4 + length;
        }

        Span<byte> hash = stackalloc byte[HMACSHA256.HashSizeInBytes];
        HMACSHA256.HashData(key, bytes.AsSpan(0, at), hash);
        ArrayPool<byte>.Shared.Return(bytes);
        return Convert.ToHexStringLower(hash);
    }

    /// <summary>A number as a value.</summary>
    public static string Number(long number) => number.ToString(CultureInfo.InvariantCulture);

    /// <summary>A number as a value; null for none.</summary>
    public static string? Number(double? number) => number?.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>A number as a value; null for none.</summary>
    public static string? Number(long? number) => number is { } some ? Number(some) : null;

    /// <summary>Codes in the form used by an audit entry: one per line, the code and the row's name.</summary>
    public static string Lines(IEnumerable<(string Name, string Code)> rows) => string.Join('\n', rows.Select(r => $"{r.Code} {r.Name}"));

    /// <summary>Reads what <see cref="Lines"/> wrote; malformed lines are skipped.</summary>
    public static IEnumerable<(string Name, string Code)> Read(string lines)
    {
        for (var (from, to) = (0, 0); from < lines.Length; from = to + 1)
        {
            to = lines.IndexOf('\n', from) is >= 0 and var end ? end : lines.Length;
            if (to - from > CodeLength + 1 && lines[from + CodeLength] == ' ')
                yield return (lines[(from + CodeLength + 1)..to], lines[from..(from + CodeLength)]);
        }
    }
}

/// <summary>A row of the store with its stored code.</summary>
/// <typeparam name="T">Type of the row's value.</typeparam>
/// <param name="Value">The row's value.</param>
/// <param name="Coded">The row in coded form.</param>
/// <param name="Code">The stored code; null for none.</param>
internal sealed record StoredRow<T>(T Value, CodedRow Coded, string? Code)
{
    /// <summary>Creates a row from its value and its coding function.</summary>
    public StoredRow(T value, Func<T, CodedRow> coded, string? code)
        : this(value, coded(value), code)
    {
    }

    /// <summary>False if a program without the key wrote the row. Without a key this cannot be verified, and the result is true.</summary>
    public bool Holds(byte[]? key) => key is null || (Code is not null && Code == Coded.Code(key));
}
