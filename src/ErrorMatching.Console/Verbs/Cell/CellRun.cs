using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Json;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;
using Serilog;
using Serilog.Core;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell run</c>.</summary>
internal sealed class CellRun : CellVerb
{
    private static readonly TimeSpan Reconnect = TimeSpan.FromSeconds(5);

    private readonly Option<bool> _standby = new("--standby")
    {
        Description = "Wait while another process runs the cell, and take over when that one ends or falls silent.",
    };

    public CellRun()
        : base(
            "run",
            "Runs a cell until Ctrl+C or SIGTERM: takes files from its gauges and brings programs to its machines.",
            "errormatch cell run samples/cell/cell.json") => Options.Add(_standby);

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var isStandby = arguments.GetValue(_standby);
        if (isStandby && settings.Store is SqliteSettings { File: var file })
        {
            return new Failure(
                ExitCode.WrongInput,
                new Refusal(
                    "standby-needs-server",
                    $"{file} is a store in a file, which is for one process on one computer: a second one there could not tell whether the "
                        + "first is dead or slow. Run the cell without --standby, or keep its store on PostgreSQL.",
                    new() { File = settings.File, Path = "$.store.kind" }));
        }

        var log = CellLog.Open(settings.LogFolder);
        try
        {
            return Run(settings, log, isStandby, cancellation);
        }
        finally
        {
            Close(log, settings);
        }
    }

    // The result of the run is not lost even if the last lines of its log are.
    private static void Close(Logger log, CellSettings settings)
    {
        try
        {
            log.Dispose();
        }
        catch (IOException e)
        {
            System.Console.Error.Write($"errormatch: the last lines of the log in {settings.LogFolder} cannot be written: {e.Message}\n");
        }
    }

    private static VerbResult Run(CellSettings settings, Logger log, bool isStandby, CancellationToken cancellation)
    {
        foreach (var warning in settings.Warnings)
        {
            log.Warning("{File}: {Path}: {Warning}", settings.File, warning.Place.Path, warning.Message);
        }

        try
        {
            return CellService.IsOne
                ? CellService.Run(stop => RunAsync(settings, log, isStandby, stop), cancellation)
                : RunAsync(settings, log, isStandby, cancellation).GetAwaiter().GetResult();
        }
        catch (Exception e)
        {
            log.Fatal("{Cell} ends: {Message}", settings.Name, e.Message);
            throw;
        }
    }

    private static async Task<VerbResult> RunAsync(
        CellSettings settings, ILogger log, bool isStandby, CancellationToken cancellation)
    {
        var clock = TimeProvider.System;
        var since = clock.GetUtcNow();
        log.Information("{Cell} looks through its store", settings.Name);
        using var store = await OpenAsync(settings, log, clock, cancellation);
        using var right = new CellRight(settings, store, clock);
        if (await TakeAsync(right, settings, log, isStandby, clock, cancellation) is { } refused) return refused;

        // A store that was rolled back does not know what was sent since, and would send it again.
        if (new AuditTrail(store, settings).EndFault() is { } fault)
        {
            log.Fatal("{Cell} does not start: {Message}", settings.Name, fault.Message);
            return FailureOfCell.Audit(fault);
        }

        using var telemetry = TelemetryExport.Start(settings.Name, Environment.GetEnvironmentVariable);
        var notice = new SystemdNotice(Environment.GetEnvironmentVariable("NOTIFY_SOCKET"));
        var secrets = new MachineSecrets(store, settings.KeysFolder);
        var runner = new CellRunner(settings, store, m => MachineFolders.Open(m, () => secrets.Get(m.Name)), clock, log)
        {
            Alive = notice.Alive
        };
        using var stopping = cancellation.Register(notice.Stopping);
        store.Audit("cell", "started", InForce(settings), settings.Name);
        notice.Ready();
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        var lost = right.UntilLostAsync(stop.Token);
        var isLost = false;
        _ = lost.ContinueWith(
            _ =>
            {
                isLost = true;
                stop.Cancel();
            },
            CancellationToken.None,
            TaskContinuationOptions.OnlyOnRanToCompletion,
            TaskScheduler.Default);
        await runner.RunAsync(stop.Token);
        if (isLost)
        {
            return new Failure(
                ExitCode.Outside,
                new Refusal(
                    "cell-taken-over",
                    $"{settings.Name}: this process was silent for so long that another one took the cell over. It has stopped and sent "
                        + "nothing more."));
        }

        await stop.CancelAsync();
        store.Audit("cell", "stopped", Recorded.Stopped.With(), settings.Name);
        new AuditTrail(store, settings).Remember();
        return new CellRunAnswer(settings, since, clock.GetUtcNow());
    }

    // Who approves, and within which limits, is part of the evidence: a raised limit shows in the trail.
    private static Statement InForce(CellSettings settings) => Recorded.Started.With(
        ContentHash.Sha256(SharedFile.ReadAllBytes(settings.File)),
        settings.Jobs.Where(j => j.Policy is not null)
            .Select(j => Recorded.PoliciesOfJob.With([j.Name, .. Words(j.Policy!)]))
            .Prepend(Recorded.PoliciesOfCell.With(Words(settings.Policy))));

    private static object[] Words(PolicySettings policy) =>
    [
        policy.Automatic ? "automatic" : "a person",
        policy.LimitMm is { } limit ? Mm(limit) : "the job's",
        policy.SumLimitMm is { } sum ? Mm(sum) : "none of its own",
        policy.Gain is { } gain ? gain : "the job's",
    ];

    private static string Mm(double mm) => string.Create(CultureInfo.InvariantCulture, $"{mm} mm");

    // Null once this process has the right to run the cell.
    private static async Task<Failure?> TakeAsync(
        CellRight right, CellSettings settings, ILogger log, bool isStandby, TimeProvider clock, CancellationToken cancellation)
    {
        var isTold = false;
        while (true)
        {
            try
            {
                switch (right.TryTake())
                {
                    case RightToRun.Taken:
                        return null;
                    case RightToRun.OfOtherCell:
                        return new Failure(
                            ExitCode.Outside,
                            new Refusal(
                                "store-of-one-cell",
                                $"Another cell runs with the store of {settings.File}, which is for one cell. Give each cell a file, or a "
                                    + "schema of the database, of its own."));
                    case RightToRun.OfOtherProcess when !isStandby:
                        return new Failure(
                            ExitCode.Outside,
                            new Refusal(
                                "cell-runs-already",
                                $"{settings.Name} runs already: another process has it. See errormatch cell status {settings.File}."));
                }

                if (!isTold) log.Information("{Cell} stands by: another process runs it", settings.Name);
                isTold = true;
            }
            catch (StoreException e) when (isStandby && e.IsWorthAnotherTry)
            {
                log.Warning("store: {Message}", e.Message);
            }

            await Task.Delay(CellRight.StandbyEvery, clock, cancellation);
        }
    }

    // Waits for a server that starts after the cell; an error that waiting does not resolve ends the run.
    private static async Task<CellStore> OpenAsync(CellSettings settings, ILogger log, TimeProvider clock, CancellationToken cancellation)
    {
        while (true)
        {
            try
            {
                return CellStore.Open(settings.Store, clock, AuditKey.OpenFor(settings));
            }
            catch (StoreException e) when (e.IsWorthAnotherTry)
            {
                log.Warning("store: {Message}", e.Message);
                await Task.Delay(Reconnect, clock, cancellation);
            }
        }
    }
}

/// <summary>A run of a cell that ended on request.</summary>
internal sealed class CellRunAnswer(CellSettings settings, DateTimeOffset since, DateTimeOffset until) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-run/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("cell", settings.Name);
        json.WriteString("since", CorrectionJson.Time(since));
        json.WriteString("until", CorrectionJson.Time(until));
    }

    public override void WriteText(Page page) =>
        page.Line($"{settings.Name} was told to stop, and stopped. Whatever it had begun is kept: the next run goes on with it.");
}
