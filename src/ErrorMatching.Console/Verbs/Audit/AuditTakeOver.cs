using System.CommandLine;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch audit take-over</c>.</summary>
internal sealed class AuditTakeOver : CellVerb
{
    private readonly Option<string> _reason = new("--reason")
    {
        Description = "Why the store may be trusted as it is. It goes into the audit trail.",
        Required = true
    };

    public AuditTakeOver()
        : base(
            "take-over",
            "Takes the end of the audit trail for the right one, after a store was set back on purpose or audit.seen was lost, and puts "
                + "that on record.",
            "errormatch audit take-over samples/cell/cell.json --reason new-disk") => Options.Add(_reason);

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        DemandStore(settings);
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.OpenFor(settings), inspect: false);
        var trail = new AuditTrail(store, settings);
        var isTaken = trail.TakeOver(SystemUser.Name(Environment.GetEnvironmentVariable), arguments.GetRequiredValue(_reason));
        return trail.EndFault() is { } fault ? FailureOfCell.Audit(fault) : new TakeOverAnswer(isTaken);
    }

    private sealed class TakeOverAnswer(bool isTaken) : DocumentAnswer
    {
        public override string Schema => "errormatch/audit-take-over/1";

        public override void WriteJson(Utf8JsonWriter json) => json.WriteBoolean("takenOver", isTaken);

        public override void WriteText(Page page) => page.Line(isTaken
            ? "The trail goes on from here, and an entry trail-set-back says so. Look at it with errormatch audit verify, and compare the "
                + "slots with the machines before the cell starts."
            : "There was nothing to take over: the trail goes on from where it was last seen.");
    }
}
