namespace ErrorMatching.Reporting;

/// <summary>The job that a report is about.</summary>
/// <param name="Name">What the job calls itself.</param>
/// <param name="WorkOrder">The shop's number of the order; null if the job has none.</param>
/// <param name="File">The job's file, as the user named it.</param>
/// <param name="Sha256">SHA-256 of its bytes.</param>
public sealed record ReportJob(string Name, string? WorkOrder, string File, string Sha256);
