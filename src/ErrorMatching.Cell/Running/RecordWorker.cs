using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Checks every few seconds whether the store was changed from outside the cell: users, slots, corrections that have not ended, or
/// the schema.</summary>
internal sealed class RecordWorker(CellFlow flow)
{
    private const string Where = "record";

    /// <summary>Checks once.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var found = flow.Store.Tampered();
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

        return Task.FromResult(flow.Pace.Idle);
    }
}
