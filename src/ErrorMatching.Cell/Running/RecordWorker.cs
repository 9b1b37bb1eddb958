namespace ErrorMatching.Cell;

/// <summary>Looks every few seconds whether somebody else wrote to the store: to users, slots, corrections that are not at their end, or
/// the form of the database.</summary>
internal sealed class RecordWorker(CellFlow flow)
{
    private const string Where = "record";

    /// <summary>Looks once.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var found = flow.Store.Tampered();
        if (found is not [var first, ..])
        {
            flow.Troubles.End(Where);
        }
        else if (flow.Troubles.Begin(Where, CellCodes.Of(StoreError.Tampered), found.Count == 1 ? first : first + " "
            + Recorded.AndMore.With(found.Count - 1)))
        {
            flow.Log.Error("{Where}: {Message}", Where, string.Join(" ", found));
            foreach (var message in found) flow.SayTampered(null, message);
        }

        return Task.FromResult(flow.Pace.Idle);
    }
}
