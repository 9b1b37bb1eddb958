namespace ErrorMatching.Cell;

/// <summary>The first place where an audit trail is not what was written.</summary>
/// <param name="Kind">What was done to it.</param>
/// <param name="Seq">The entry's number, as it should be: the first that is changed, missing, inserted or out of order.</param>
/// <param name="Message">A sentence about it.</param>
public sealed record AuditFault(AuditFaultKind Kind, long Seq, string Message);
