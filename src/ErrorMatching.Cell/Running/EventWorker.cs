using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Publishes each step of the cell to the broker. Nothing waits for it: it reads the audit trail behind the other workers, and
/// continues from where the broker had everything.</summary>
/// <remarks>A broker may acknowledge a message before its disk has it, and forget it in a power cut. So a message counts as delivered
/// only if the same connection still answers some seconds after the acknowledgment. Later messages are published again, with the same
/// identity. That holds for an orderly stop, too: restarting cell and broker together must not lose a step.</remarks>
internal sealed class EventWorker : IAsyncDisposable
{
    /// <summary>The part's name in troubles.</summary>
    public const string Where = "events";

    private const int Most = 100;

    // Acknowledgments that are nearer to each other than this part of the delay are one.
    private const int Parts = 8;

    // Packets have 16-bit numbers. No two messages that the broker may have half received have the same.
    private const int MostUnsettled = 60_000;

    private static readonly TimeSpan Goodbye = TimeSpan.FromSeconds(1);
    private readonly CellFlow _flow;
    private readonly EventSettings _broker;
    private readonly EventCursor _cursor;
    private readonly StepFeed _feed;
    private readonly string _client;
    private readonly List<(long Begin, long At, long Seq)> _acknowledged = [];
    private BrokerSession? _session;
    private bool _hasSession;
    private long _published;
    private long _mayHave;
    private long _settled;
    private long _answered;
    private (IReadOnlyList<GaugeBacklog> Backlog, long? At) _announced = ([], null);

    /// <summary>Creates the worker of a cell.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public EventWorker(CellFlow flow, EventSettings broker)
    {
        (_flow, _broker) = (flow, broker);
        _cursor = new(flow.Store, flow.Settings.Name);
        _feed = new(flow.Store, flow.Settings);
        _cursor.Begin();
        _client = ClientOf(flow.Store, flow.Settings.Name);
    }

    /// <summary>Publishes what is new.</summary>
    /// <returns>How long to wait before looking again.</returns>
    /// <exception cref="BrokerException">The broker does not take it.</exception>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        try
        {
            return await PublishAsync(_session ??= await OpenAsync(stop), stop);
        }
        catch (BrokerException)
        {
            _session?.Dispose();
            _session = null;
            throw;
        }
    }

    /// <summary>Ends the session. What the broker acknowledged in the last seconds is published again by the next process.</summary>
    public async ValueTask DisposeAsync()
    {
        if (_session is not { } session)
        {
            return;
        }

        _session = null;
        using var limit = new CancellationTokenSource(Goodbye);
        try
        {
            await session.EndAsync(limit.Token);
        }
        catch (Exception e) when (e is BrokerException or OperationCanceledException)
        {
            _flow.Log.Debug("{Where}: {Message}", Where, e.Message);
        }
        finally
        {
            session.Dispose();
        }
    }

    // Messages whose acknowledgment a broken connection cut off are published again in the same session, with the same numbers.
    // Numbers of an earlier process mean nothing to this one, so its first session is a new one.
    private async Task<BrokerSession> OpenAsync(CancellationToken stop)
    {
        var session = await BrokerSession.OpenAsync(_broker, _client, _hasSession, _flow.Pace.BrokerAnswer, stop);
        _mayHave = Math.Max(_mayHave, _published);
        _published = _settled = _cursor.Read();
        _acknowledged.Clear();
        _answered = _flow.Clock.GetTimestamp();
        _hasSession = true;
        _flow.Log.Information("{Where}: connected to {Broker}", Where, _broker.Address);
        return session;
    }

    private async Task<TimeSpan> PublishAsync(BrokerSession session, CancellationToken stop)
    {
        var before = _published;
        if (before - _settled < MostUnsettled && (!_flow.Store.Database.IsPushed || _flow.Store.HeardOf() != before))
        {
            var (steps, last) = _feed.After(before, Most);
            foreach (var step in steps)
            {
                var seq = step.Entry.Seq;
                var isAgain = seq <= _mayHave;
                _mayHave = Math.Max(_mayHave, seq);
                await session.PublishAsync(NumberOf(seq), isAgain, step.Message(_flow.Settings.Name), stop);
                Acknowledged(seq);
            }

            _published = last;
        }

        await AnnounceAsync(session, stop);
        if (_flow.Clock.GetElapsedTime(_answered) >= _flow.Pace.BrokerPing)
        {
            await session.PingAsync(stop);
            Answered();
        }

        // What is no step needs no acknowledgment.
        if (_acknowledged.Count == 0)
        {
            Settle(_published);
        }

        return _published > before ? TimeSpan.Zero : _flow.Pace.BrokerPing;
    }

    // What waits is not a step: only its last state matters, and it is told again.
    private async Task AnnounceAsync(BrokerSession session, CancellationToken stop)
    {
        var backlog = _flow.Backlogs.All;
        var isNews = !backlog.SequenceEqual(_announced.Backlog);
        if (backlog.Count == 0
            || _announced.At is { } at && _flow.Clock.GetElapsedTime(at) < (isNews ? _flow.Pace.BacklogNews : _flow.Pace.BacklogAgain))
        {
            return;
        }

        await session.AnnounceAsync(
            _broker.BacklogTopic,
            BacklogEvent.Message(_flow.Settings.Name, backlog, _flow.Clock.GetUtcNow()),
            3 * _flow.Pace.BacklogAgain,
            stop);
        _announced = (backlog, _flow.Clock.GetTimestamp());
    }

    private void Acknowledged(long seq)
    {
        Answered();
        _published = seq;
        if (_acknowledged is [.., var last] && _flow.Clock.GetElapsedTime(last.Begin, _answered) < _flow.Pace.BrokerSettle / Parts)
        {
            _acknowledged[^1] = (last.Begin, _answered, seq);
        }
        else
        {
            _acknowledged.Add((_answered, _answered, seq));
        }
    }

    // By the clock that nobody sets: a clock set forward would count what the broker has just acknowledged.
    private void Answered()
    {
        _answered = _flow.Clock.GetTimestamp();
        if (_acknowledged.FindLastIndex(m => _flow.Clock.GetElapsedTime(m.At, _answered) >= _flow.Pace.BrokerSettle) is >= 0 and var last)
        {
            Settle(_acknowledged[last].Seq);
            _acknowledged.RemoveRange(0, last + 1);
        }
    }

    private void Settle(long seq)
    {
        if (seq > _settled)
        {
            _cursor.Advance(seq);
            _settled = seq;
        }
    }

    // Every message that a broker may have half received has a number of its own, and the same one when it is published again.
    private static ushort NumberOf(long seq) => (ushort)(1 + (seq % ushort.MaxValue));

    // One session for each cell of each store; the first entry of a store is like no other.
    private static string ClientOf(CellStore store, string cell)
    {
        var first = store.AuditEntries(0, 1) is [var entry] ? entry.Hash : AuditEntry.NoHash;
        return "errormatch-" + ContentHash.Sha256OfText($"{first}\n{cell}")[..12];
    }
}
