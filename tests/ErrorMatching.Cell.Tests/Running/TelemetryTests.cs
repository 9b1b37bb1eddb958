using System.Collections.Concurrent;
using System.Diagnostics;
using System.Diagnostics.Metrics;

namespace ErrorMatching.Cell.Tests;

public sealed class TelemetryTests
{
    [Fact]
    public async Task A_file_is_one_trace_from_its_arrival_to_the_machine_also_over_a_restart()
    {
        var done = new ConcurrentQueue<Activity>();
        using var listener = new ActivityListener
        {
            ShouldListenTo = s => s.Name == "ErrorMatching.Cell",
            Sample = (ref ActivityCreationOptions<ActivityContext> _) => ActivitySamplingResult.AllDataAndRecorded,
            ActivityStopped = done.Enqueue,
        };
        ActivitySource.AddActivityListener(listener);
        await using var cell = new RunningCell(policy: """{ "approve": "person" }""");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        await cell.StopAsync();
        new CorrectionDecisions(cell.Store).Approve(1, "sam", null);
        cell.Start();
        var verified = await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();

        // Other tests run beside this one: only this cell's trace counts.
        var trace = ActivityContext.Parse(verified.Trace!, null).TraceId;
        var ours = done.Where(a => a.TraceId == trace).ToArray();
        Assert.Equal(
            ["archive", "compute", "file to verified", "propose", "recognize", "upload"], ours.Select(a => a.OperationName).Order());
        var whole = ours.Single(a => a.OperationName == "file to verified");
        Assert.Equal(verified.ArrivedAt.UtcDateTime, whole.StartTimeUtc);
        Assert.True(whole.StartTimeUtc + whole.Duration >= verified.ChangedAt.UtcDateTime);
    }

    [Fact]
    public async Task Steps_and_latency_are_counted()
    {
        var states = new ConcurrentBag<string>();
        var latencies = new ConcurrentBag<double>();
        using var listener = new MeterListener
        {
            InstrumentPublished = (i, l) => _ = i.Meter.Name == "ErrorMatching.Cell" ? Enable(i, l) : 0
        };
        listener.SetMeasurementEventCallback<long>((i, value, tags, _) =>
        {
            if (i.Name == "errormatch.cell.steps")
            {
                states.Add((string)tags[0].Value!);
            }
        });
        listener.SetMeasurementEventCallback<double>((i, value, _, _) => latencies.Add(value));
        listener.Start();
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        Assert.Superset(
            new HashSet<string>(["archived", "recognized", "computed", "proposed", "approved", "uploading", "verified"]),
            states.ToHashSet());
        var verified = cell.Store.Find(1)!;
        Assert.Contains(latencies, l => l >= (verified.ChangedAt - verified.ArrivedAt).TotalSeconds);
    }

    [Theory]
    [InlineData(null, null, null, false)]
    [InlineData("OTEL_EXPORTER_OTLP_ENDPOINT", "http://127.0.0.1:9", null, true)]
    [InlineData("OTEL_EXPORTER_OTLP_TRACES_ENDPOINT", "http://127.0.0.1:9", null, true)]
    [InlineData("OTEL_EXPORTER_OTLP_ENDPOINT", "http://127.0.0.1:9", "OTEL_SDK_DISABLED", false)]
    public void Nothing_is_sent_unless_the_standard_variables_say_where(string? name, string? value, string? disabled, bool isOn)
    {
        using var export = TelemetryExport.Start("cell", v => v == name ? value : v == disabled ? "true" : null);
        Assert.Equal(isOn, export.IsOn);
    }

    private static int Enable(Instrument instrument, MeterListener listener)
    {
        listener.EnableMeasurementEvents(instrument);
        return 1;
    }
}
