using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Compares ASCII words without regard to case, and looks them up by a program's bytes without creating strings.</summary>
internal sealed class KeywordComparer : IEqualityComparer<string>, IAlternateEqualityComparer<ReadOnlySpan<byte>, string>
{
    public static KeywordComparer Instance { get; } = new();

    public bool Equals(string? x, string? y) => string.Equals(x, y, StringComparison.OrdinalIgnoreCase);

    // FNV-1a over upper-case characters: the same for text and bytes.
    public int GetHashCode(string obj)
    {
        var hash = 2166136261u;
        foreach (var c in obj)
        {
            hash = (hash ^ Upper((byte)c)) * 16777619u;
        }

        return (int)hash;
    }

    public int GetHashCode(ReadOnlySpan<byte> alternate)
    {
        var hash = 2166136261u;
        foreach (var b in alternate)
        {
            hash = (hash ^ Upper(b)) * 16777619u;
        }

        return (int)hash;
    }

    public bool Equals(ReadOnlySpan<byte> alternate, string other) => Ascii.EqualsIgnoreCase(alternate, other);

    public string Create(ReadOnlySpan<byte> alternate) => Encoding.ASCII.GetString(alternate).ToUpperInvariant();

    private static byte Upper(byte b) => (uint)(b - 'a') < 26 ? (byte)(b & ~0x20) : b;
}
