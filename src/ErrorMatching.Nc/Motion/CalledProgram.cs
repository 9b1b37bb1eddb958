namespace ErrorMatching.Nc;

/// <summary>A program that the interpreted one calls and that is in another file.</summary>
/// <param name="Name">The name by which it is called: <c>O1002</c>, <c>POCKET</c>.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lower-case hexadecimal digits.</param>
public sealed record CalledProgram(string Name, string Sha256);
