using System.Diagnostics;
using Serilog;

namespace ErrorMatching.Cell;

/// <summary>Runs a cell until told to stop: takes files from its gauges, computes, and sends programs to machines. Each step is stored
/// before it has any visible effect, and every worker finds its work in the store by state. So however a runner ends, the next one
/// continues where it was.</summary>
public sealed class CellRunner
{
    private const int Computers = 2;
    private readonly CellSettings _settings;
    private readonly CellStore _store;
    private readonly Func<MachineSettings, IMachineFolder> _open;
    private readonly TimeProvider _clock;
    private readonly ILogger _log;

    /// <summary>Creates a runner for a cell.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="store">The open store.</param>
    /// <param name="open">Opens a machine's folder, such as by <see cref="MachineFolders.Open"/> with the machine's secret.</param>
    /// <param name="clock">The clock.</param>
    /// <param name="log">The log.</param>
    public CellRunner(CellSettings settings, CellStore store, Func<MachineSettings, IMachineFolder> open, TimeProvider clock, ILogger log)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(open);
        (_settings, _store, _open, _clock, _log) = (settings, store, open, clock, log);
    }

    /// <summary>Called every few seconds while the cell runs.</summary>
    public Action? Alive { get; init; }

    /// <summary>The waiting times.</summary>
    internal FlowPace Pace { get; init; } = new();

    /// <summary>Called before and after each step with the new state.</summary>
    internal Action<CorrectionState, bool>? AroundStep { get; init; }

    /// <summary>Called with a worker's name each time it starts to look for work.</summary>
    internal Action<string>? Looking { get; init; }

    /// <summary>Runs until told to stop; then finishes or gives back what it holds, within 10 s.</summary>
    /// <param name="stop">Signals it to stop.</param>
    public async Task RunAsync(CancellationToken stop)
    {
        using var finish = new CancellationTokenSource();
        using var end = CancellationTokenSource.CreateLinkedTokenSource(stop);
        using var atStop = end.Token.UnsafeRegister(_ => finish.CancelAfter(Pace.Finish), null);
        var flow = new CellFlow(_settings, _store, _clock, _log, Pace, finish.Token) { AroundStep = AroundStep, Looking = Looking };
        using var lines = CellTelemetry.Watch(() => Lines(flow));
        using var sources = new Sources(flow, _open);
        using var folders = new OpenFolders(_settings, _open);
        await using var events = _settings.Events is { } broker ? new EventWorker(flow, broker) : null;
        AllowForWaiting();
        var workers = Workers(flow, sources, folders, events).Select(
            w => Task.Run(() => w(end.Token), CancellationToken.None)).ToArray();
        _log.Information(
            "{Cell} runs: {Gauges} gauges, {Slots} slots",
            _settings.Name,
            _settings.Gauges.Count,
            _settings.Machines.Sum(m => m.Slots.Count));

        // A worker must end only when told to: one that ends earlier is a defect, and stops the others too.
        var first = await Task.WhenAny(workers);
        await end.CancelAsync();
        await Task.WhenAny(Task.WhenAll(workers), Task.Delay(Pace.Finish + Pace.GiveBack + Pace.Deaf, CancellationToken.None));
        Heartbeat.Remove(_settings.LogFolder);
        if (!stop.IsCancellationRequested)
        {
            await first;
            throw new UnreachableException("A worker of the cell ended by itself.");
        }

        _log.Information("{Cell} stopped", _settings.Name);
    }

    private IEnumerable<Func<CancellationToken, Task>> Workers(
        CellFlow flow, Sources sources, OpenFolders folders, EventWorker? events)
    {
        var originals = new OriginalPrograms(_settings);
        var programs = new JobPrograms(_settings);
        foreach (var (gauge, source) in sources.All)
        {
            yield return new Worker(flow, CellTrouble.OfGauge(gauge), new(), source.WorkAsync).RunAsync;
        }

        foreach (var gauge in _settings.Gauges.Where(g => g.Incoming is not null))
        {
            yield return new Worker(flow, $"watch of gauge {gauge.Name}", new(), AnswerWatch.OfGauge(flow, gauge).WorkAsync).RunAsync;
        }

        foreach (var gauge in _settings.Gauges)
        {
            yield return new Worker(
                flow, $"backlog of gauge {gauge.Name}", new(), new BacklogWorker(flow, gauge).WorkAsync).RunAsync;
        }

        yield return new Worker(flow, "recognition", flow.Archived, new RecognizeWorker(flow).WorkAsync).RunAsync;
        var computing = new ComputeWorker(flow);
        for (var i = 0; i < Computers; i++)
        {
            yield return new Worker(flow, $"computing {i + 1}", flow.Recognized, computing.WorkAsync).RunAsync;
        }

        yield return new Worker(flow, "approval", flow.Computed, new ProposeWorker(flow).WorkAsync).RunAsync;
        foreach (var (machine, folder) in folders.All)
        {
            var listing = new MachineListing(folder, _clock, Pace.Ready);
            var guard = ReplacementGuard.Of(machine, _clock);
            var tries = TransferTries.For(machine, _clock, ReportTry);
            if (guard is not null)
            {
                yield return new Worker(flow, $"asking {machine.Name}", new(),
                    new MachineStateWorker(flow, machine, guard).WorkAsync).RunAsync;
                yield return new Worker(flow, $"watch of the state of {machine.Name}", new(),
                    AnswerWatch.OfState(flow, machine, guard).WorkAsync).RunAsync;
            }

            yield return new Worker(flow, $"watch of {machine.Name}", new(),
                AnswerWatch.OfMachine(flow, machine, folder).WorkAsync).RunAsync;
            foreach (var slot in machine.Slots)
            {
                var place = SlotPlace.Of(_store, machine, slot, folder, tries, guard);
                var worker = new SlotWorker(
                    flow,
                    place,
                    new HeldProgram(flow, place, listing),
                    new KnownPrograms(flow, place, originals),
                    new SlotNames(flow, place, programs),
                    new DeliveryWait(flow, place, guard));
                yield return new Worker(
                    flow, CellTrouble.OfSlot(machine.Name, slot.Name), flow.OfSlot(machine.Name, slot.Name), worker.WorkAsync).RunAsync;
            }
        }

        if (events is not null)
        {
            yield return new Worker(flow, EventWorker.Where, flow.Stepped, events.WorkAsync).RunAsync;
        }

        yield return new Worker(flow, "unserved", new(), new UnservedWorker(flow).WorkAsync).RunAsync;
        yield return new Worker(flow, "looking at the record", new(), new RecordWorker(flow).WorkAsync).RunAsync;
        yield return new Worker(flow, WitnessWorker.Where, flow.Stepped, new WitnessWorker(flow).WorkAsync).RunAsync;
        yield return new Worker(flow, "store", new(), new StoreWatch(flow).WorkAsync).RunAsync;
        yield return new Worker(flow, "heartbeat", new(), new HeartbeatWorker(flow, Alive).WorkAsync).RunAsync;
    }

    private void ReportTry(TransferTry t) =>
        _log.Debug("{Machine}: try {Try} failed, next in {Wait}: {Message}", t.Machine, t.Number, t.Wait, t.Failure.Message);

    // A step blocks its thread while it waits for the disk. With one thread per core, the pool's initial size, transfers for other slots
    // would have to wait too, and the pool grows by only two threads a second.
    private void AllowForWaiting()
    {
        ThreadPool.GetMinThreads(out var threads, out var ports);
        ThreadPool.SetMinThreads(Math.Max(threads, (2 * (_settings.Gauges.Count + _settings.Machines.Sum(m => m.Slots.Count + 1))) + 16),
            ports);
    }

    private static IEnumerable<(string Machine, string Slot, long Waiting)> Lines(CellFlow flow) =>
        flow.Settings.Machines.SelectMany(m => m.Slots.Select(
            s => (m.Name, s.Name, (long)flow.Store.Corrections.Line(m.Name, s.Name).Count)));
}

/// <summary>The workers of all gauges, which listen for folder changes until they are disposed of.</summary>
internal sealed class Sources(CellFlow flow, Func<MachineSettings, IMachineFolder> open) : IDisposable
{
    /// <summary>Each gauge's name and worker.</summary>
    public IReadOnlyList<(string Gauge, SourceWorker Source)> All { get; } = [
        .. flow.Settings.Gauges.Select(g => (g.Name, new SourceWorker(flow, g, open)))];

    public void Dispose()
    {
        foreach (var (_, source) in All)
        {
            source.Dispose();
        }
    }
}

/// <summary>The program folders of all machines, open as long as a cell runs.</summary>
internal sealed class OpenFolders(CellSettings settings, Func<MachineSettings, IMachineFolder> open) : IDisposable
{
    /// <summary>Each machine and its folder.</summary>
    public IReadOnlyList<(MachineSettings Machine, IMachineFolder Folder)> All { get; } = [.. settings.Machines.Select(m => (m, open(m)))];

    public void Dispose()
    {
        foreach (var (_, folder) in All)
        {
            folder.Dispose();
        }
    }
}

/// <summary>Detects changes to the store by other processes, such as an approval at the console, and wakes the workers.</summary>
internal sealed class StoreWatch(CellFlow flow)
{
    private long _seen = -1;

    /// <summary>Checks once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var now = flow.Store.HeardOf();
        if (now != _seen)
        {
            _seen = now;
            flow.TellAll();
        }

        return Task.FromResult(flow.Pace.Store);
    }
}
