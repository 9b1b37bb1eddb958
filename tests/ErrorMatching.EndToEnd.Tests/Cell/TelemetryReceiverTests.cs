using System.Net;
using System.Net.Sockets;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What a running cell tells a receiver of telemetry, and that nothing hangs on the receiver.</summary>
public sealed class TelemetryReceiverTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);
    private static readonly string[] Parts = ["archive", "compute", "file to verified", "propose", "recognize", "upload"];

    [Fact]
    public async Task A_file_arrives_there_as_one_trace_from_the_gauge_to_the_machine_and_so_do_the_metrics()
    {
        using var receiver = new OtlpReceiver();
        using var cell = new FireCell(slots: 2);
        var files = new FireFiles();
        var pieces = cell.Slots.Select((slot, i) => files.Next(slot, i)).ToArray();
        cell.Start(Variables(receiver.Endpoint, "http/protobuf"));
        foreach (var (name, bytes) in pieces)
        {
            cell.Drop(name, bytes);
        }

        await cell.Until(
            () => Task.FromResult(receiver.Spans.Count(s => s.Name == "file to verified") == 2 && receiver.Metrics.Count >= 3),
            Patience,
            "telemetry arrives");
        await cell.Stop();

        Assert.Empty(receiver.Wrong);
        Assert.All(receiver.Spans, s => Assert.Equal("errormatch-cell", s.Service));
        var traces = receiver.Spans.GroupBy(s => s.Trace).ToArray();
        Assert.Equal(2, traces.Length);
        Assert.All(traces, trace =>
        {
            Assert.Equal(Parts, trace.Select(s => s.Name).Order(StringComparer.Ordinal));
            var first = trace.Single(s => s.Parent.Length == 0);
            Assert.Equal(("archive", 32, 16), (first.Name, first.Trace.Length, first.Id.Length));
            Assert.All(trace.Where(s => s != first), s => Assert.Equal(first.Id, s.Parent));
            Assert.All(trace, s => Assert.True(s.Start <= s.End));
            Assert.Equal(6, trace.Select(s => s.Id).Distinct().Count());
        });
        Assert.Equal(
            traces.Select(t => t.Key).Order(StringComparer.Ordinal),
            (await cell.History()).Select(c => c.GetProperty("trace").GetString()!.Split('-')[1]).Order(StringComparer.Ordinal));
        Assert.Equal(
            ["errormatch.cell.arrived_to_verified", "errormatch.cell.line", "errormatch.cell.steps"],
            receiver.Metrics.Keys.Order(StringComparer.Ordinal));
        Assert.All(receiver.Metrics.Values, service => Assert.Equal("errormatch-cell", service));
    }

    [Fact]
    public async Task A_receiver_that_is_away_keeps_nothing_from_working() => await Works($"http://127.0.0.1:{FreePort()}", "grpc");

    [Theory]
    [InlineData("http/protobuf")]
    [InlineData("grpc")]
    public async Task A_receiver_that_hangs_keeps_nothing_from_working_or_from_ending(string protocol)
    {
        using var receiver = new OtlpReceiver(hangs: true);
        await Works(receiver.Endpoint, protocol, () => receiver.Connections > 0);
    }

    private static async Task Works(string endpoint, string protocol, Func<bool>? isSent = null)
    {
        using var cell = new FireCell(slots: 1);
        var piece = new FireFiles().Next(cell.Slots[0], 1);
        cell.Start(Variables(endpoint, protocol));
        cell.Drop(piece.Name, piece.Bytes);
        await cell.Until(async () => await cell.StateOf(piece.Name) == "verified", Patience, "the program is at the machine");
        await cell.Until(() => Task.FromResult(isSent?.Invoke() ?? true), Patience, "something is sent");

        // The kits that send would wait for 5 s; the cell does for 1 s.
        await cell.Stop(atMost: TimeSpan.FromSeconds(4));
    }

    private static (string, string)[] Variables(string endpoint, string protocol) =>
    [
        ("OTEL_EXPORTER_OTLP_ENDPOINT", endpoint), ("OTEL_EXPORTER_OTLP_PROTOCOL", protocol), ("OTEL_BSP_SCHEDULE_DELAY", "100"),
        ("OTEL_METRIC_EXPORT_INTERVAL", "300"),
    ];

    private static int FreePort()
    {
        using var probe = new TcpListener(IPAddress.Loopback, 0);
        probe.Start();
        return ((IPEndPoint)probe.LocalEndpoint).Port;
    }
}
