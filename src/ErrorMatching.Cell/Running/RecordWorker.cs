using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Checks every few seconds whether the store was changed from outside the cell: users, slots, corrections that have not ended, or
/// the schema. Keeps the checkpoint of the audit trail up to date, and looks at the entries before the one that the cell went on
/// from. Looks whether all archives are in their folder.</summary>
internal sealed class RecordWorker(CellFlow flow)
{
    private const string Where = "record";
    private const string OfArchives = "archives";

    // Years of entries take half an hour at this pace, and a thirtieth of a core.
    private const int Behind = 20_000;

    /// <summary>Checks once.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        flow.Store.Outside.KeepCheckpoint(stop);
        flow.ReportWholeTrail();
        var behind = flow.Store.Outside.LookBehind(Behind);
        IReadOnlyList<Statement> found = [.. behind is null ? Array.Empty<Statement>() : [behind], .. flow.Store.Tampered()];
        if (found is not [var first, ..])
        {
            flow.Troubles.End(Where);
        }
        else if (flow.Troubles.Begin(
            Where,
            CellCodes.Of(StoreError.Tampered),
            Statement.InARow(first, found.Count == 1 ? "" : Recorded.AndMore.With(found.Count - 1))))
        {
            flow.Log.Error("{Where}: {Message}", Where, string.Join(" ", found));
            foreach (var message in found) flow.ReportTampered(null, message);
        }

        if (flow.Store.MissingArchives() is not [var missing, ..])
        {
            flow.Troubles.End(OfArchives);
        }
        else if (flow.Troubles.Begin(OfArchives, CellCodes.Of(StoreError.Archived), missing))
        {
            flow.Log.Warning("{Where}: {Message}", OfArchives, missing);
        }

        return Task.FromResult(flow.Pace.Idle);
    }
}
