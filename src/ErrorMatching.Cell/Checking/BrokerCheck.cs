namespace ErrorMatching.Cell;

/// <summary>Checks whether a broker lets the cell in. Nothing is published, so it does not find out whether it may publish.</summary>
internal static class BrokerCheck
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(10);

    public static async Task<CheckedBroker> OfAsync(EventSettings broker, CancellationToken cancellation)
    {
        try
        {
            // A session of its own: that of a running cell must not end.
            var client = "errormatch-check-" + Guid.NewGuid().ToString("N")[..8];
            using var session = await BrokerSession.OpenAsync(broker, client, isResumed: false, Limit, cancellation).ConfigureAwait(false);
            await session.EndAsync(cancellation).ConfigureAwait(false);
            return new(broker, null);
        }
        catch (BrokerException e)
        {
            return new(broker, CheckProblem.Of(CellCodes.Of(e.Error), e.Message));
        }
    }
}

/// <summary>The broker, after a login.</summary>
/// <param name="Broker">Its settings.</param>
/// <param name="Problem">Why it did not let the cell in; null if it did.</param>
public sealed record CheckedBroker(EventSettings Broker, CheckProblem? Problem);
