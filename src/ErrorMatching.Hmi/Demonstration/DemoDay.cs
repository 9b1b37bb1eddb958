using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A gauge that delivers by itself and a machine that cuts by itself, so that there is something to see and to decide.</summary>
/// <param name="cell">The cell.</param>
/// <param name="clock">The clock.</param>
public sealed class DemoDay(DemoCell cell, TimeProvider clock)
{
    private const int MostWaiting = 3;
    private const double SpreadMm = 0.02;
    private static readonly TimeSpan First = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan BetweenParts = TimeSpan.FromSeconds(20);
    private static readonly TimeSpan Cutting = TimeSpan.FromSeconds(15);

    /// <summary>Goes on until told to end.</summary>
    public async Task RunAsync(CancellationToken end)
    {
        try
        {
            using var store = CellStore.Open(cell.Settings.Store, clock, AuditKey.Open(cell.Settings.KeysFolder));
            await Task.WhenAll(MeasureAsync(store, end), CutAsync(store, end));
        }
        catch (OperationCanceledException) when (end.IsCancellationRequested)
        {
            // The day is over.
        }
    }

    private async Task MeasureAsync(CellStore store, CancellationToken end)
    {
        await Task.Delay(First, clock, end);
        for (var serial = 1; ; serial++)
        {
            cell.Deliver(serial, serial == 1 ? 0 : SpreadMm);
            do
            {
                await Task.Delay(BetweenParts, clock, end);
            }
            while (store.InState(CorrectionState.Proposed).Count >= MostWaiting);
        }
    }

    private async Task CutAsync(CellStore store, CancellationToken end)
    {
        while (true)
        {
            await Task.Delay(TimeSpan.FromSeconds(1), clock, end);
            if (store.InState(CorrectionState.Verified) is [var held, ..] && clock.GetUtcNow() - held.ChangedAt >= Cutting)
            {
                cell.FinishPiece();
            }
        }
    }
}
