using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Json;

/// <summary>The hash by which content is recognized, wherever its file is.</summary>
public static class ContentHash
{
    /// <summary>SHA-256 of bytes, as 64 lower-case hexadecimal digits.</summary>
    public static string Sha256(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    /// <summary>SHA-256 of a text in UTF-8, as 64 lower-case hexadecimal digits.</summary>
    public static string Sha256OfText(string text) => Sha256(Encoding.UTF8.GetBytes(text));
}
