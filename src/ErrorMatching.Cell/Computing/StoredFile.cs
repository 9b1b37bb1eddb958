using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>A file that the cell stores, held in memory: it is not read from disk again.</summary>
/// <param name="Name">Its name on arrival, without folders.</param>
/// <param name="Bytes">Its content.</param>
public sealed record StoredFile(string Name, ReadOnlyMemory<byte> Bytes)
{
    /// <summary>SHA-256 of its content as 64 lower-case hexadecimal digits.</summary>
    public string Sha256 => Convert.ToHexStringLower(SHA256.HashData(Bytes.Span));
}
