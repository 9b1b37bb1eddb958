using ErrorMatching.Reporting;
using Serilog;

namespace ErrorMatching.Cell;

/// <summary>State shared by the workers of a running cell: the store, the signals between workers, and the common way to take
/// steps.</summary>
internal sealed class CellFlow(
    CellSettings settings, CellStore store, TimeProvider clock, ILogger log, FlowPace pace, CancellationToken finish)
{
    /// <summary>The user name for steps that no person decides.</summary>
    public const string ByCell = AuditEntry.ByCell;

    private readonly Dictionary<(string Machine, string Slot), Wake> _slots = settings.Machines
        .SelectMany(m => m.Slots.Select(s => (m.Name, s.Name))).ToDictionary(k => k, _ => new Wake());

    private readonly System.Collections.Concurrent.ConcurrentDictionary<string, bool> _saidTampered = new(StringComparer.Ordinal);

    /// <summary>Names of this cell's gauges; another cell with the same store has others.</summary>
    public IReadOnlyList<string> Gauges { get; } = [.. settings.Gauges.Select(g => g.Name)];

    /// <summary>Names of this cell's jobs.</summary>
    public IReadOnlyList<string> Jobs { get; } = [.. settings.Jobs.Select(j => j.Name)];

    /// <summary>The configuration.</summary>
    public CellSettings Settings => settings;

    /// <summary>The store.</summary>
    public CellStore Store => store;

    /// <summary>The clock.</summary>
    public TimeProvider Clock => clock;

    /// <summary>The log.</summary>
    public ILogger Log => log;

    /// <summary>The waiting times.</summary>
    public FlowPace Pace => pace;

    /// <summary>How long to wait for work without a signal.</summary>
    public TimeSpan Idle => store.Database.IsPushed ? pace.Told : pace.Idle;

    /// <summary>Canceled some seconds after the cell was told to stop: work in progress may finish until then.</summary>
    public CancellationToken Finish => finish;

    /// <summary>What prevents workers from working.</summary>
    public Troubles Troubles { get; } = new(clock);

    /// <summary>What the machines are doing, and what waits for them.</summary>
    public MachineReports Machines { get; } = new(clock);

    /// <summary>What waits at the gauges.</summary>
    public Backlogs Backlogs { get; } = new();

    /// <summary>Wakes the worker that recognizes.</summary>
    public Wake Archived { get; } = new();

    /// <summary>Wakes the workers that compute.</summary>
    public Wake Recognized { get; } = new();

    /// <summary>Wakes the worker that proposes.</summary>
    public Wake Computed { get; } = new();

    /// <summary>Wakes the worker that publishes steps.</summary>
    public Wake Stepped { get; } = new();

    /// <summary>Called before and after each step of this process with the new state; tests end the process there.</summary>
    public Action<CorrectionState, bool>? AroundStep { get; init; }

    /// <summary>Called with a worker's name each time it starts to look for work; tests wait for it.</summary>
    public Action<string>? Looking { get; init; }

    /// <summary>The policy that applies to a correction's job.</summary>
    public PolicySettings PolicyOf(Correction correction) =>
        settings.Jobs.FirstOrDefault(j => j.Name == correction.Job)?.Policy ?? settings.Policy;

    /// <summary>Wakes the worker of a slot.</summary>
    public Wake OfSlot(string machine, string slot) => _slots[(machine, slot)];

    /// <summary>Takes a step: stores it first, then logs it, counts it and wakes the workers concerned.</summary>
    /// <exception cref="StoreException">It was not taken.</exception>
    public Correction Step(
        Correction from,
        CorrectionState to,
        Statement basis,
        Func<Correction, Correction>? with = null,
        IReadOnlyList<ReadOnlyMemory<byte>>? contents = null,
        bool isPageOfReport = false)
    {
        AroundStep?.Invoke(to, false);
        var now = store.Step(from, to, ByCell, basis, with, contents, isPageOfReport);
        AroundStep?.Invoke(to, true);
        StepLog.Write(log, from.State, now, basis.Sentence);
        CellTelemetry.Count(now);
        Report(now);
        return now;
    }

    /// <summary>Ensures that a correction may go to its machine according to all records. A reason against it is recorded once.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/> if it may not.</exception>
    public void DemandRecorded(Correction correction)
    {
        try
        {
            store.Outside.DemandRecorded(correction);
            ReportWholeTrail();
        }
        catch (StoreException e) when (e.Error == StoreError.Tampered)
        {
            ReportTampered(Recorded.Correction.With(correction.Id), e.Statement);
            throw;
        }
    }

    /// <summary>Says once why the whole audit trail was read. A checkpoint that somebody else wrote is recorded.</summary>
    public void ReportWholeTrail()
    {
        if (store.Outside.WhyWhole is not { } why || _saidTampered.ContainsKey(why.Text)) return;
        log.Warning("{Where}: {Message}", "record", why.Sentence);
        if (why.Is(RecordedCheckpoint.Foreign) || why.Is(RecordedCheckpoint.Astray)) ReportTampered(null, why);
        else _saidTampered.TryAdd(why.Text, true);
    }

    /// <summary>Records a change to the store from outside the cell, once while the cell runs.</summary>
    public void ReportTampered(Statement? subject, Statement message)
    {
        if (_saidTampered.TryAdd(message.Text, true)) store.Audit(ByCell, AuditLedger.Tampered, message, subject);
    }

    /// <summary>Stores an arrival, and wakes the workers concerned if it is new.</summary>
    /// <exception cref="StoreException">It was not stored.</exception>
    public void Arrive(Func<(Correction Correction, bool IsNew)> archive)
    {
        AroundStep?.Invoke(CorrectionState.Archived, false);
        var (arrived, isNew) = archive();
        AroundStep?.Invoke(CorrectionState.Archived, true);
        if (isNew)
        {
            StepLog.Write(log, null, arrived, arrived.Reason?.Sentence ?? $"arrived from {arrived.Gauge}");
            CellTelemetry.Count(arrived);
            Report(arrived);
        }
    }

    /// <summary>Processes a file. If the file causes an exception, it alone fails, and the next one gets its turn.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public void FailingAlone(Correction correction, Action work)
    {
        try
        {
            work();
        }
        catch (StoreException e) when (e.Error is StoreError.Damaged or StoreError.Missing or StoreError.Archived
            or StoreError.Tampered)
        {
            Fail(correction, CellCodes.Of(e.Error), e.Statement);
        }
        catch (Exception e) when (e is not (StoreException or OperationCanceledException))
        {
            log.Error(e, "{FileName} ({Correction}): a defect of errormatch", correction.FileName, correction.Id);
            Fail(correction, CellCodes.Defect, Recorded.Defect.With(e.GetType().Name, e.Message));
        }
    }

    private void Fail(Correction correction, string code, Statement reason) =>
        Step(correction, CorrectionState.Failed, reason, c =>
            c with { Code = code, Reason = reason, Identity = null, ProgramSha256 = null });

    /// <summary>Wakes the workers concerned with a correction's state.</summary>
    public void Report(Correction correction)
    {
        Stepped.Signal();
        switch (CorrectionSteps.Of(correction.State).TakenBy)
        {
            case StateWorker.Recognize:
                Archived.Signal();
                break;
            case StateWorker.Compute:
                Recognized.Signal();
                break;
            case StateWorker.Propose:
                Computed.Signal();
                break;
            default:
                // The line that it was in may move.
                if (correction is { Machine: { } machine, Slot: { } slot } && _slots.TryGetValue((machine, slot), out var wake))
                {
                    wake.Signal();
                }

                break;
        }
    }

    /// <summary>Wakes all workers: another process may have changed anything.</summary>
    public void TellAll()
    {
        foreach (var wake in _slots.Values.Concat([Archived, Recognized, Computed, Stepped]))
        {
            wake.Signal();
        }
    }
}

/// <summary>The format of steps in the log.</summary>
internal static class StepLog
{
    /// <summary>Logs a stored step.</summary>
    public static void Write(ILogger log, CorrectionState? from, Correction now, string basis)
    {
        var level = CorrectionSteps.Of(now.State).Level;
        if (log.IsEnabled(level))
        {
            log.ForContext("From", from?.ToString().ToLowerInvariant())
                .ForContext("Job", now.Job)
                .ForContext("Serial", now.Serial)
                .ForContext("WorkOrder", now.WorkOrder)
                .ForContext("Machine", now.Machine).ForContext("Slot", now.Slot).ForContext("Trace", now.Trace)
                .Write(
                    level,
                    "{Correction} {FileName}: {State:l}: {Basis:l}",
                    now.Id,
                    now.FileName,
                    now.State.ToString().ToLowerInvariant(),
                    now.Code is { } code ? $"{code}: {basis}" : basis);
        }
    }
}
