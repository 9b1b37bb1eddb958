namespace ErrorMatching.Nc;

/// <summary>A file that a dialect was read from.</summary>
/// <param name="File">The file as the caller named it, or as the file that continues it did, seen from where the caller is.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lower-case hexadecimal digits.</param>
public sealed record DialectFile(string File, string Sha256);
