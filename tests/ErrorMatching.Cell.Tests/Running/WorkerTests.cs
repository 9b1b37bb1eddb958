using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

public sealed class WorkerTests
{
    public static TheoryData<Exception, string?> Failures => new()
    {
        { new StoreException(StoreError.Conflict, "Correction 1 changed."), null },
        { new SlotTakenException("m1", "A", 7), null },
        { new StoreException(StoreError.Full, "The disk is full."), "store-full" },
        { new SourceException("The folder is away.", new IOException()), "gauge-away" },
        { new TransportException(TransportError.Away, "The machine is away."), "machine-away" },
        { new BrokerException(BrokerError.WrongServer, "Another broker."), "broker-wrong-server" },
        { new InvalidOperationException("Nobody thought of this."), "internal-error" },
    };

    [Theory]
    [MemberData(nameof(Failures))]
    public async Task What_another_process_did_first_is_no_trouble_and_what_fails_is_one_until_it_works(Exception failure, string? code)
    {
        await using var cell = new RunningCell();
        using var stop = new CancellationTokenSource();
        var flow = new CellFlow(cell.Settings, cell.Store, TimeProvider.System, Logger.None, cell.Pace, CancellationToken.None);
        IReadOnlyList<CellTrouble> meanwhile = [];
        var looks = 0;
        await new Worker(flow, "slot m1/A", new Wake(), Work).RunAsync(stop.Token);
        Assert.Equal(3, looks);
        Assert.Equal(code is null ? [] : [("slot m1/A", code)], meanwhile.Select(t => (t.Where, t.Code)));
        Assert.Empty(flow.Troubles.Open);

        async Task<TimeSpan> Work(CancellationToken token)
        {
            looks++;
            if (looks < 3)
            {
                throw failure;
            }

            meanwhile = flow.Troubles.Open;
            await stop.CancelAsync();
            return TimeSpan.Zero;
        }
    }
}
