using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The first place where an audit trail differs from what was written.</summary>
/// <param name="Kind">The kind of fault.</param>
/// <param name="Seq">The correct number of the first entry that is changed, missing, inserted or out of order.</param>
/// <param name="Statement">What is wrong.</param>
public sealed record AuditFault(AuditFaultKind Kind, long Seq, Statement Statement)
{
    /// <summary>A sentence that describes it.</summary>
    public string Message => Statement.Sentence;
}
