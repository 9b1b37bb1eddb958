namespace ErrorMatching.Reporting;

/// <summary>An input file of a result.</summary>
/// <param name="Role">Its role: <c>theoretical</c>, <c>part</c>, <c>counterpart</c>, <c>counterpart-after</c>, <c>program</c> or
/// <c>dialect</c> (a shop's own).</param>
/// <param name="File">The file, as the user named it.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lowercase hexadecimal digits.</param>
public sealed record ReportInput(string Role, string File, string Sha256);
