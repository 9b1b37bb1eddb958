namespace ErrorMatching.Cell;

/// <summary>A job as it was saved at a time, kept by content in the store.</summary>
/// <param name="Entry">Number of its entry in the audit trail.</param>
/// <param name="At">When it was saved, or found where nobody had saved it here.</param>
/// <param name="By">Who saved it, or what took its place.</param>
/// <param name="Name">What the job was called: the workpiece; empty where the file does not say.</param>
/// <param name="Sha256">SHA-256 of the job's file.</param>
/// <param name="Files">All its own files by their names, the job's file last: their SHA-256.</param>
public sealed record JobVersion(
    long Entry, DateTimeOffset At, string By, string Name, string Sha256, IReadOnlyList<(string Name, string Sha256)> Files);
