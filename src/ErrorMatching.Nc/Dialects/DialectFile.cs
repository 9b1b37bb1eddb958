namespace ErrorMatching.Nc;

/// <summary>A file from which a dialect was read.</summary>
/// <param name="File">The file as named by the caller or by the file that continues it, relative to the caller's place.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lower-case hexadecimal digits.</param>
public sealed record DialectFile(string File, string Sha256);
