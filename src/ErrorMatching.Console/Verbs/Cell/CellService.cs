using System.Runtime.ExceptionServices;
using System.ServiceProcess;
using ErrorMatching.Refusals;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Hosting.WindowsServices;
using Microsoft.Extensions.Logging;

namespace ErrorMatching.Console;

/// <summary>Runs a cell as a service of Windows: started, stopped and restarted by the service control manager.</summary>
/// <remarks>The generic host gives nothing but this life cycle. Configuration, logs and the order of things are those of
/// <c>cell run</c> at a console, so there is one way in which a cell runs.</remarks>
internal static partial class CellService
{
    private const string ServiceName = "errormatch";

    // ERROR_EXCEPTION_IN_SERVICE: ended, and not because anybody asked.
    private const int Ended = 1064;

    // The cell finishes or gives back what it holds within 10 s.
    private static readonly TimeSpan StopWithin = TimeSpan.FromSeconds(15);

    /// <summary>True if the service control manager has started this process.</summary>
    public static bool IsOne => OperatingSystem.IsWindows() && WindowsServiceHelpers.IsWindowsService();

    /// <summary>Runs a cell until the service control manager stops it.</summary>
    /// <param name="work">Runs the cell; ends soon after its token is canceled.</param>
    /// <param name="cancellation">Also stops it.</param>
    /// <returns>What the work returned.</returns>
    public static VerbResult Run(Func<CancellationToken, Task<VerbResult>> work, CancellationToken cancellation) =>
        Run(work, services => services.AddWindowsService(o => o.ServiceName = ServiceName), ReportEnd, cancellation);

    /// <summary>The same with another life cycle.</summary>
    /// <param name="work">Runs the cell; ends soon after its token is canceled.</param>
    /// <param name="lifetime">Adds what starts and stops the host.</param>
    /// <param name="ended">Called if the work ended by itself, before the host stops.</param>
    /// <param name="cancellation">Also stops it.</param>
    internal static VerbResult Run(
        Func<CancellationToken, Task<VerbResult>> work,
        Action<IServiceCollection> lifetime,
        Action<IHostLifetime> ended,
        CancellationToken cancellation)
    {
        // The name is the source in the Event Log, which deploy/windows-service.ps1 registers.
        var builder = Host.CreateEmptyApplicationBuilder(new() { DisableDefaults = true, ApplicationName = ServiceName });
        lifetime(builder.Services);
        builder.Services.Configure<HostOptions>(o => o.ShutdownTimeout = StopWithin);
        builder.Services.AddSingleton(work);
        builder.Services.AddSingleton(ended);
        builder.Services.AddSingleton<Work>();
        builder.Services.AddHostedService(s => s.GetRequiredService<Work>());
        using var host = builder.Build();
        var running = host.Services.GetRequiredService<Work>();
        host.RunAsync(cancellation).GetAwaiter().GetResult();
        running.Failure?.Throw();
        return running.Result ?? new Failure(ExitCode.Cancelled, new Refusal("cancelled", "Stopped before the cell had begun."));
    }

    // The recovery actions of the service apply to an end with an error.
    private static void ReportEnd(IHostLifetime lifetime)
    {
        if (OperatingSystem.IsWindows() && lifetime is ServiceBase service)
        {
            service.ExitCode = Ended;
        }
    }

    [LoggerMessage(LogLevel.Critical, "The cell ended by itself: {Reason}")]
    private static partial void ReportEnd(ILogger log, string reason);

    private sealed class Work(
        Func<CancellationToken, Task<VerbResult>> work,
        Action<IHostLifetime> ended,
        IHostLifetime lifetime,
        IHostApplicationLifetime application,
        ILogger<Work> log) : BackgroundService
    {
        public VerbResult? Result { get; private set; }

        public ExceptionDispatchInfo? Failure { get; private set; }

        protected override async Task ExecuteAsync(CancellationToken stoppingToken)
        {
            // The manager waits for the start, and a store on a server may take its time.
            await Task.Yield();
            try
            {
                Result = await work(stoppingToken);
            }
            catch (OperationCanceledException) when (stoppingToken.IsCancellationRequested)
            {
                // It was stopped while it waited for its store.
            }
#pragma warning disable CA1031 // It is thrown again where the command ends, for its message and exit code.
            catch (Exception e)
            {
                Failure = ExceptionDispatchInfo.Capture(e);
            }
#pragma warning restore CA1031
            if (!stoppingToken.IsCancellationRequested)
            {
                // In the Event Log, where people look who look after services.
                var reason = Failure?.SourceException.Message ?? ReasonOf(Result);
                ReportEnd(log, reason);
                ended(lifetime);
                application.StopApplication();
            }
        }

        private static string ReasonOf(VerbResult? result) =>
            result is Failure { Errors: [var first, ..] } ? first.Message : "no reason given";
    }
}
