namespace ErrorMatching.Cell;

/// <summary>Remembers the end of the audit trail outside of the store while the cell runs: every hundred entries, and every half a minute.
/// The more often this happens, the less can be cut off unnoticed.</summary>
/// <param name="flow">State shared by the workers.</param>
internal sealed class WitnessWorker(CellFlow flow)
{
    /// <summary>The part's name in troubles.</summary>
    public const string Where = "end of the audit trail";

    private const int MostEntries = 100;
    private long? _at;
    private long _seq;

    /// <summary>Remembers the end if there are enough new entries, or they are old enough.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var seq = flow.Store.HeardOf();
        if (_at is not { } at || seq - _seq >= MostEntries || flow.Clock.GetElapsedTime(at) >= flow.Pace.Witness)
        {
            (_at, _seq) = (flow.Clock.GetTimestamp(), seq);
            Remember();
        }

        return Task.FromResult(flow.Pace.Witness - flow.Clock.GetElapsedTime(_at.Value) is { Ticks: > 0 } rest ? rest : flow.Pace.Witness);
    }

    // A disk for keys that is full, or a share that is away, does not stop the cell.
    private void Remember()
    {
        try
        {
            if (new AuditTrail(flow.Store, flow.Settings).Remember() is not { } fault) flow.Troubles.End(Where);
            else if (flow.Troubles.Begin(Where, CellCodes.Of(StoreError.Tampered), fault.Statement))
                flow.Log.Error("{Where}: {Message}", Where, fault.Message);
        }
        catch (PeopleException e)
        {
            if (flow.Troubles.Begin(Where, CellCodes.NotKept, e.Message)) flow.Log.Warning("{Where}: {Message}", Where, e.Message);
        }
    }
}
