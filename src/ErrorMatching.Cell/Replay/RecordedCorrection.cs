namespace ErrorMatching.Cell;

/// <summary>What the audit trail says of a correction.</summary>
/// <param name="file">SHA-256 of the file that it arrived with.</param>
internal sealed class RecordedCorrection(string file)
{
    /// <summary>SHA-256 of the file that it arrived with.</summary>
    public string File => file;

    /// <summary>Its state.</summary>
    public CorrectionState State { get; set; }

    /// <summary>The computed program; null before that.</summary>
    public string? Program { get; set; }

    /// <summary>Number of the entry of its last step.</summary>
    public long Seq { get; set; }

    /// <summary>The first of its steps that was not allowed; null if there is none.</summary>
    public AuditFault? Fault { get; set; }
}
