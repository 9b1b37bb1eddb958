using Serilog;

namespace ErrorMatching.Cell;

/// <summary>What the workers of a running cell share: the store, the signals between them, and the one way in which they take steps.</summary>
internal sealed class CellFlow(CellSettings settings, CellStore store, TimeProvider clock, ILogger log, FlowPace pace, CancellationToken finish)
{
    /// <summary>Who takes the steps that nobody decides on.</summary>
    public const string ByCell = "cell";

    private readonly Dictionary<(string Machine, string Slot), Wake> _slots = settings.Machines
        .SelectMany(m => m.Slots.Select(s => (m.Name, s.Name))).ToDictionary(k => k, _ => new Wake());

    private readonly System.Collections.Concurrent.ConcurrentDictionary<string, bool> _saidTampered = new(StringComparer.Ordinal);

    /// <summary>Names of this cell's gauges; another cell of the same store has others.</summary>
    public IReadOnlyList<string> Gauges { get; } = [.. settings.Gauges.Select(g => g.Name)];

    /// <summary>Names of this cell's jobs.</summary>
    public IReadOnlyList<string> Jobs { get; } = [.. settings.Jobs.Select(j => j.Name)];

    /// <summary>The configuration.</summary>
    public CellSettings Settings => settings;

    /// <summary>Where everything is kept.</summary>
    public CellStore Store => store;

    /// <summary>The clock.</summary>
    public TimeProvider Clock => clock;

    /// <summary>The log.</summary>
    public ILogger Log => log;

    /// <summary>How long is waited for what.</summary>
    public FlowPace Pace => pace;

    /// <summary>Cancelled some seconds after the cell was told to stop: what has begun by then may come to its end until here.</summary>
    public CancellationToken Finish => finish;

    /// <summary>What keeps workers from working.</summary>
    public Troubles Troubles { get; } = new(clock);

    /// <summary>Wakes who recognizes.</summary>
    public Wake Archived { get; } = new();

    /// <summary>Wakes who computes.</summary>
    public Wake Recognized { get; } = new();

    /// <summary>Wakes who proposes.</summary>
    public Wake Computed { get; } = new();

    /// <summary>Called before and after each step of this process with the state it leads to; tests end the process there.</summary>
    public Action<CorrectionState, bool>? AroundStep { get; init; }

    /// <summary>Called with a worker's name whenever it begins to look for work; tests wait for it.</summary>
    public Action<string>? Looking { get; init; }

    /// <summary>What holds for a correction's job.</summary>
    public PolicySettings PolicyOf(Correction correction) => settings.Jobs.FirstOrDefault(j => j.Name == correction.Job)?.Policy ?? settings.Policy;

    /// <summary>Wakes who serves a slot.</summary>
    public Wake OfSlot(string machine, string slot) => _slots[(machine, slot)];

    /// <summary>Takes a step: kept first, then logged, counted and told to whom it concerns.</summary>
    /// <exception cref="StoreException">It was not taken.</exception>
    public Correction Step(Correction from, CorrectionState to, string basis, Func<Correction, Correction>? with = null, IReadOnlyList<ReadOnlyMemory<byte>>? contents = null)
    {
        AroundStep?.Invoke(to, false);
        var now = store.Step(from, to, ByCell, basis, with, contents);
        AroundStep?.Invoke(to, true);
        StepLog.Write(log, from.State, now, basis);
        CellTelemetry.Count(now);
        Tell(now);
        return now;
    }

    /// <summary>Makes sure that a correction may go to its machine by all that is recorded; what stands against it is put on record
    /// once.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/> if it may not.</exception>
    public void DemandRecorded(Correction correction)
    {
        try
        {
            store.DemandRecorded(correction);
        }
        catch (StoreException e) when (e.Error == StoreError.Tampered)
        {
            SayTampered(Recorded.Correction.With(correction.Id), e.Message);
            throw;
        }
    }

    /// <summary>Puts on record, once while the cell runs, what somebody else did to the store.</summary>
    public void SayTampered(string? subject, string message)
    {
        if (_saidTampered.TryAdd(message, true)) store.Audit(ByCell, AuditLedger.Tampered, message, subject);
    }

    /// <summary>Keeps an arrival, and tells whom it concerns if it is new.</summary>
    /// <exception cref="StoreException">It was not kept.</exception>
    public void Arrive(Func<(Correction Correction, bool IsNew)> archive)
    {
        AroundStep?.Invoke(CorrectionState.Archived, false);
        var (arrived, isNew) = archive();
        AroundStep?.Invoke(CorrectionState.Archived, true);
        if (isNew)
        {
            StepLog.Write(log, null, arrived, arrived.Reason ?? $"arrived from {arrived.Gauge}");
            CellTelemetry.Count(arrived);
            Tell(arrived);
        }
    }

    /// <summary>Does something with a file. Whatever the file does to the reader, it fails alone, and the next one gets its turn.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public void Guarded(Correction correction, Action work)
    {
        try
        {
            work();
        }
        catch (StoreException e) when (e.Error is StoreError.Damaged or StoreError.Missing or StoreError.Tampered)
        {
            Fail(correction, CellCodes.Of(e.Error), e.Message);
        }
        catch (Exception e) when (e is not (StoreException or OperationCanceledException))
        {
            log.Error(e, "{FileName} ({Correction}): a defect of errormatch", correction.FileName, correction.Id);
            Fail(correction, CellCodes.Defect, Recorded.Defect.With(e.GetType().Name, e.Message));
        }
    }

    private void Fail(Correction correction, string code, string reason) =>
        Step(correction, CorrectionState.Failed, reason, c =>
            c with { Code = code, Reason = reason, Identity = null, ProgramSha256 = null });

    /// <summary>Wakes whom a correction's state concerns.</summary>
    public void Tell(Correction correction)
    {
        switch (correction.State)
        {
            case CorrectionState.Archived:
                Archived.Signal();
                break;
            case CorrectionState.Recognized:
                Recognized.Signal();
                break;
            case CorrectionState.Computed or CorrectionState.Proposed:
                Computed.Signal();
                break;
            default:
                // Where it stood in a line, the line may move.
                if (correction is { Machine: { } machine, Slot: { } slot } && _slots.TryGetValue((machine, slot), out var wake))
                {
                    wake.Signal();
                }

                break;
        }
    }

    /// <summary>Wakes everybody: another process may have done anything.</summary>
    public void TellAll()
    {
        foreach (var wake in _slots.Values.Concat([Archived, Recognized, Computed]))
        {
            wake.Signal();
        }
    }
}
