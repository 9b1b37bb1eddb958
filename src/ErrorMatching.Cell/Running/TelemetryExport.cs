using OpenTelemetry;
using OpenTelemetry.Metrics;
using OpenTelemetry.Resources;
using OpenTelemetry.Trace;

namespace ErrorMatching.Cell;

/// <summary>Sends metrics and traces as the standard OpenTelemetry variables say. Without <c>OTEL_EXPORTER_OTLP_ENDPOINT</c> (or its
/// variant for traces or metrics), nothing is collected or sent.</summary>
public sealed class TelemetryExport : IDisposable
{
    // A receiver that hangs must not delay a cell's stop.
    private static readonly TimeSpan LastTry = TimeSpan.FromSeconds(1);

    private readonly IDisposable?[] _providers;

    private TelemetryExport(params IDisposable?[] providers) => _providers = providers;

    /// <summary>True if anything is exported.</summary>
    public bool IsOn => _providers.Any(p => p is not null);

    /// <summary>Starts the export, if the variables ask for it.</summary>
    /// <param name="cell">The cell's name, which <c>OTEL_RESOURCE_ATTRIBUTES</c> may add to.</param>
    /// <param name="variable">Reads an environment variable.</param>
    public static TelemetryExport Start(string cell, Func<string, string?> variable)
    {
        ArgumentNullException.ThrowIfNull(variable);
        if (string.Equals(variable("OTEL_SDK_DISABLED"), "true", StringComparison.OrdinalIgnoreCase))
        {
            return new();
        }

        return new(
            Wants("TRACES")
                ? Sdk.CreateTracerProviderBuilder().ConfigureResource(Describe).AddSource(CellTelemetry.Name).AddOtlpExporter().Build()
                : null,
            Wants("METRICS")
                ? Sdk.CreateMeterProviderBuilder().ConfigureResource(Describe).AddMeter(CellTelemetry.Name).AddOtlpExporter().Build()
                : null);

        bool Wants(string signal) =>
            !string.Equals(variable($"OTEL_{signal}_EXPORTER"), "none", StringComparison.OrdinalIgnoreCase)
            && !(
                string.IsNullOrEmpty(variable("OTEL_EXPORTER_OTLP_ENDPOINT"))
                    && string.IsNullOrEmpty(variable($"OTEL_EXPORTER_OTLP_{signal}_ENDPOINT")));

        void Describe(ResourceBuilder resource) => resource.AddService(
            variable("OTEL_SERVICE_NAME") is { Length: > 0 } name ? name : "errormatch-cell",
            serviceInstanceId: cell).AddEnvironmentVariableDetector();
    }

    /// <summary>Sends what is left, and ends within a second: data that the receiver has not accepted by then is lost.</summary>
    public void Dispose()
    {
        var ends = _providers
            .OfType<IDisposable>()
            .Select(p => Task.Factory.StartNew(p.Dispose, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default))
            .ToArray();
        Task.WaitAll(ends, LastTry);
    }
}
