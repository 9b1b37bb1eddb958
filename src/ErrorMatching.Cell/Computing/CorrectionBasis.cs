namespace ErrorMatching.Cell;

/// <summary>The inputs that a correction is based on. Hashes are SHA-256 as 64 lowercase hexadecimal digits.</summary>
/// <param name="Identity">The correction's identity (<see cref="CorrectionIdentity"/>).</param>
/// <param name="JobSha256">The job's file.</param>
/// <param name="Job">Its content.</param>
/// <param name="BaseSha256">The base program; null if the program is generated.</param>
/// <param name="Base">Its content; null if the program is generated.</param>
/// <param name="WorkOrder">The work order that the job names; null if there is none.</param>
public sealed record CorrectionBasis(
    string Identity, string JobSha256, ReadOnlyMemory<byte> Job, string? BaseSha256, ReadOnlyMemory<byte>? Base, string? WorkOrder);
