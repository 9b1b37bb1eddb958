namespace ErrorMatching.Reporting;

/// <summary>The job of a report.</summary>
/// <param name="Name">The job's name.</param>
/// <param name="WorkOrder">The shop's order number; null if the job has none.</param>
/// <param name="File">The job's file, as the user named it.</param>
/// <param name="Sha256">SHA-256 of its bytes.</param>
public sealed record ReportJob(string Name, string? WorkOrder, string File, string Sha256);
