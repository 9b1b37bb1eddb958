namespace ErrorMatching.Cell;

/// <summary>The first place where an audit trail differs from what was written.</summary>
/// <param name="Kind">The kind of fault.</param>
/// <param name="Seq">The correct number of the first entry that is changed, missing, inserted or out of order.</param>
/// <param name="Message">A sentence that describes it.</param>
public sealed record AuditFault(AuditFaultKind Kind, long Seq, string Message);
