using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Simulates a gauge that delivers files and a machine that cuts, so that there is something to see and to decide.</summary>
/// <param name="cell">The cell.</param>
/// <param name="clock">The clock.</param>
internal sealed class DemoDay(DemoCell cell, TimeProvider clock)
{
    internal const double SpreadMm = 0.003, SurfaceSpreadMm = 0.0005;

    // A machine repeats better than parts resemble each other.
    internal const double CutSpreadMm = SpreadMm / 4;
    private const int MostWaiting = 3;
    private static readonly TimeSpan First = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan Look = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan BetweenParts = TimeSpan.FromSeconds(40);
    private static readonly TimeSpan FirstSurface = TimeSpan.FromSeconds(8);
    private static readonly TimeSpan BetweenSurfaces = TimeSpan.FromMinutes(2);
    // Long enough to look at the program at the machine, short enough to wait for.
    private static readonly TimeSpan Cutting = TimeSpan.FromSeconds(60);

    private readonly HashSet<int> _measured = [];

    /// <summary>Runs until canceled.</summary>
    public async Task RunAsync(CancellationToken end)
    {
        try
        {
            using var store = CellStore.Open(cell.Settings.Store, clock, AuditKey.Open(cell.Settings.KeysFolder));
            await Task.WhenAll(MeasureAsync(store, end), ScanAsync(store, end), CutAsync(store, end));
        }
        catch (OperationCanceledException) when (end.IsCancellationRequested)
        {
            // The demonstration ends.
        }
    }

    private async Task MeasureAsync(CellStore store, CancellationToken end)
    {
        await Task.Delay(First, clock, end);
        var jobs = new ChangedJobs(cell.Settings);
        for (var serial = 1; ; serial++)
        {
            cell.Deliver(serial, SpreadOf(serial));

            // A user who has just saved the job wants to see its effect: earlier corrections do not count, and the next part comes at once.
            var ((_, outdated), delivered) = (Waiting(store, jobs), clock.GetTimestamp());
            while (true)
            {
                await Task.Delay(Look, clock, end);
                var waiting = Waiting(store, jobs);
                var isSaved = waiting.Current == 0 && waiting.Outdated > outdated;
                if (waiting.Current < MostWaiting && clock.GetElapsedTime(delivered) >= (isSaved ? First : BetweenParts))
                {
                    break;
                }
            }
        }
    }

    private async Task ScanAsync(CellStore store, CancellationToken end)
    {
        await Task.Delay(FirstSurface, clock, end);
        for (var serial = 1; ; serial++)
        {
            cell.DeliverSurface(serial, serial == 1 ? 0 : SurfaceSpreadMm);
            do
            {
                await Task.Delay(BetweenSurfaces, clock, end);
            }
            while (store.Corrections.InState(CorrectionState.Proposed).Any(c => c.Piece == PieceWords.Surface));
        }
    }

    private async Task CutAsync(CellStore store, CancellationToken end)
    {
        while (true)
        {
            await Task.Delay(TimeSpan.FromSeconds(1), clock, end);
            foreach (var held in store.Corrections.InState(CorrectionState.Verified).Where(c => clock.GetUtcNow() - c.ChangedAt >= Cutting))
            {
                Measure(store, held);
                cell.FinishPiece(held.Machine);
            }

            // A user has already reported it as cut.
            foreach (var cut in store.Corrections.InState(CorrectionState.Released))
            {
                Measure(store, cut);
            }
        }
    }

    // The part's gauge measures its counterpart, once, as the sent program cuts it, so that the user sees the effect of the job.
    private void Measure(CellStore store, Correction cut)
    {
        if (cut is { Piece: PieceWords.Part, Serial: { } serial, ReportSha256: { } report }
            && int.TryParse(serial, NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            && StoredReport.Read(store.Content(report)).Match is { } match && _measured.Add(number))
        {
            cell.DeliverCounterpart(
                number,
                CutSpreadMm,
                StoredPiece.Predicted(cut, match).Result.Points.ToDictionary(p => p.Label, p => p.After, StringComparer.Ordinal));
        }
    }

    // Computed with the current job, and with an earlier version of it.
    private static (int Current, int Outdated) Waiting(CellStore store, ChangedJobs jobs)
    {
        var waiting = store.Corrections.InState(CorrectionState.Proposed).Where(c => c.Piece == PieceWords.Part).ToArray();
        var outdated = jobs.Among(store, waiting).Count;
        return (waiting.Length - outdated, outdated);
    }

    private static double SpreadOf(int serial) => serial == 1 ? 0 : SpreadMm;
}
