namespace ErrorMatching.Cell;

/// <summary>What the audit trail says of a correction.</summary>
/// <param name="file">SHA-256 of the file that it came in with.</param>
internal sealed class RecordedCorrection(string file)
{
    /// <summary>The file that it came in with.</summary>
    public string File => file;

    /// <summary>How far it has come.</summary>
    public CorrectionState State { get; set; }

    /// <summary>The program that was computed; null before.</summary>
    public string? Program { get; set; }

    /// <summary>Number of the entry of its last step.</summary>
    public long Seq { get; set; }

    /// <summary>The first of its steps that must not have been taken; null if there is none.</summary>
    public AuditFault? Fault { get; set; }
}
