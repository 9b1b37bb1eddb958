namespace ErrorMatching.Cell;

/// <summary>A saved version of a job, stored by content.</summary>
/// <param name="Entry">Number of its entry in the audit trail.</param>
/// <param name="At">When it was saved, or found if it was not saved here.</param>
/// <param name="By">Who saved or replaced it.</param>
/// <param name="Name">The job's name then: the workpiece; empty if the file has none.</param>
/// <param name="Sha256">SHA-256 of the job's file.</param>
/// <param name="Files">SHA-256 of all its own files by name, the job's file last.</param>
public sealed record JobVersion(
    long Entry, DateTimeOffset At, string By, string Name, string Sha256, IReadOnlyList<(string Name, string Sha256)> Files);
