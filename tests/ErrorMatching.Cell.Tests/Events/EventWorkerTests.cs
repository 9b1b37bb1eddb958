using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;
using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

/// <summary>Which steps count as delivered: those whose acknowledgment came, and outlived the time that a broker may need to put them on
/// its disk.</summary>
public sealed class EventWorkerTests : IAsyncDisposable
{
    private const int Steps = 19;
    private readonly BrokerDouble _broker = new();
    private readonly RunningCell _cell = new();
    private readonly CellStore _store;
    private readonly long _begin;

    public EventWorkerTests()
    {
        _store = _cell.Store;
        _begin = _store.AuditHead().Seq;
    }

    [Fact]
    public async Task An_orderly_stop_does_not_count_as_delivered_what_the_broker_may_still_forget()
    {
        var settled = await PublishAsync(Steps, TimeSpan.FromHours(1));

        Assert.Equal(0, settled);
        await PublishAsync(2 * Steps, TimeSpan.FromHours(1), arrivals: 0);
        Assert.Equal(Published, _broker.Heard.Take(Steps));
        Assert.Equal(Published, _broker.Heard.Skip(Steps));
    }

    [Fact]
    public async Task A_step_that_is_not_acknowledged_is_not_delivered_however_the_cell_stops()
    {
        _broker.MostReceived = 7;

        // Every acknowledgment counts as soon as the broker answers once more.
        var settled = await PublishAsync(8, TimeSpan.Zero);

        Assert.InRange(settled, 6, 7);
        _broker.MostReceived = int.MaxValue;
        await PublishAsync(8 + Steps - (int)settled, TimeSpan.Zero, arrivals: 0);
        Assert.Equal(Published, _broker.Heard.Distinct());
    }

    [Fact]
    public async Task A_step_whose_acknowledgment_is_not_complete_is_not_delivered()
    {
        _broker.MostCompleted = 4;

        var settled = await PublishAsync(5, TimeSpan.Zero);

        Assert.InRange(settled, 3, 4);
        _broker.MostCompleted = int.MaxValue;
        await PublishAsync(5 + Steps - (int)settled, TimeSpan.Zero, arrivals: 0);
        Assert.Equal(Published, _broker.Heard.Distinct());
    }

    [Fact]
    public async Task What_the_broker_has_kept_long_enough_is_delivered_once_if_the_cell_stops_in_order()
    {
        var settled = await PublishAsync(Steps, TimeSpan.FromMilliseconds(1), until: s => s == Steps);

        Assert.Equal(Steps, settled);
        await PublishAsync(Steps + 1, TimeSpan.FromMilliseconds(1), arrivals: 1);
        Assert.Equal(Published, _broker.Heard);
    }

    [Fact]
    public async Task The_plant_hears_what_waits_and_the_broker_keeps_the_last_of_it()
    {
        var since = new DateTimeOffset(2026, 1, 2, 3, 4, 5, TimeSpan.Zero);
        await PublishAsync(
            1, TimeSpan.Zero, arrivals: 1, until: _ => _broker.Announced is not null, backlog: new("cmm", 1069, since, 2, null));

        var (topic, isKept, text) = _broker.Announced!.Value;
        using var message = JsonDocument.Parse(text);
        Assert.Equal(("plant/steps/backlog", true), (topic, isKept));
        Assert.Equal(1071, message.RootElement.GetProperty("waiting").GetInt64());
        Assert.Equal("2026-01-02T03:04:05Z", message.RootElement.GetProperty("oldestSince").GetString());
        Assert.True(message.RootElement.GetProperty("oldestS").GetInt64() > 0);
        Assert.Equal(1069, message.RootElement.GetProperty("gauges")[0].GetProperty("files").GetInt32());
        var page = File.ReadAllText(Repository.PathTo("docs", "events.md"));
        Assert.All(
            message.RootElement.EnumerateObject().Concat(message.RootElement.GetProperty("gauges")[0].EnumerateObject()),
            m => Assert.Contains($"`{m.Name}`", page, StringComparison.Ordinal));
    }

    public async ValueTask DisposeAsync()
    {
        await _broker.DisposeAsync();
        await _cell.DisposeAsync();
    }

    // Identities of the steps of the trail, in order.
    private IEnumerable<string> Published => _store.AuditEntries(_begin, int.MaxValue).Select(e => e.Hash);

    // A process that publishes until the broker has heard so much, and is stopped in order; how much counts as delivered then.
    private async Task<long> PublishAsync(
        int heard, TimeSpan settle, int arrivals = Steps, Func<long, bool>? until = null, GaugeBacklog? backlog = null)
    {
        var flow = new CellFlow(
            _cell.Settings,
            _store,
            TimeProvider.System,
            Logger.None,
            new() { BrokerPing = TimeSpan.FromMilliseconds(10), BrokerSettle = settle },
            CancellationToken.None);
        if (backlog is not null) flow.Backlogs.Note(backlog);
        var cursor = new EventCursor(_store, _cell.Settings.Name);
        using var stop = new CancellationTokenSource();
        await using (var events = new EventWorker(flow, _broker.Settings))
        {
            var run = Task.Run(() => new Worker(flow, EventWorker.Where, flow.Stepped, events.WorkAsync).RunAsync(stop.Token));
            for (var i = 0; i < arrivals; i++)
            {
                var name = FormattableString.Invariant($"{_store.AuditHead().Seq}.csv");
                flow.Arrive(() => _store.Archive(new Arrival("cmm", name, name, Encoding.UTF8.GetBytes(name))));
            }

            await RunningCell.Until(() => _broker.Heard.Count >= heard && until?.Invoke(cursor.Read() - _begin) != false);
            await stop.CancelAsync();
            await run;
        }

        return cursor.Read() - _begin;
    }
}
