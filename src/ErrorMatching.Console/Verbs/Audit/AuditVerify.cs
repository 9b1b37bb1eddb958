using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch audit verify</c>.</summary>
internal sealed class AuditVerify()
    : CellVerb(
        "verify",
        "Looks whether any entry of the audit trail was changed, removed, inserted or reordered.",
        "errormatch audit verify samples/cell/cell.json")
{
    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        DemandStore(settings);
        using var store = CellStore.OpenToRead(settings.Store, TimeProvider.System, AuditKey.Find(settings.KeysFolder));
        using var progress = new CellProgressLine(ProgressTo);
        var finding = new AuditTrail(store, settings).Verify(progress, cancellation);
        return finding.Fault is { } fault ? FailureOfCell.Audit(fault) : new AuditVerifyAnswer(finding);
    }
}
