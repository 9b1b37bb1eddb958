namespace ErrorMatching.Cell;

/// <summary>What a correction stands on. Hashes are SHA-256 as 64 lower-case hexadecimal digits.</summary>
/// <param name="Identity">The correction's identity (<see cref="CorrectionIdentity"/>).</param>
/// <param name="JobSha256">The job's file.</param>
/// <param name="Job">Its content.</param>
/// <param name="BaseSha256">The program that the correction starts from; null where a program is made anew.</param>
/// <param name="Base">Its content; null where a program is made anew.</param>
/// <param name="WorkOrder">The work order that the job names; null if it names none.</param>
public sealed record CorrectionBasis(string Identity, string JobSha256, ReadOnlyMemory<byte> Job, string? BaseSha256, ReadOnlyMemory<byte>? Base, string? WorkOrder);
