using System.Collections.Concurrent;
using System.Globalization;
using System.Net.Sockets;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A receiver of telemetry on a loopback port, by OTLP over HTTP. Sources: the OTLP specification 1.x and its files trace.proto,
/// metrics.proto and common.proto.</summary>
internal sealed class OtlpReceiver : IDisposable
{
    private readonly LoopbackServer _server;
    private readonly bool _hangs;

    /// <summary>Starts it.</summary>
    /// <param name="hangs">True for one that takes what it is told and never answers.</param>
    public OtlpReceiver(bool hangs = false)
    {
        _hangs = hangs;
        _server = new(AnswerAsync);
        _server.Start();
    }

    /// <summary>Where to send.</summary>
    public string Endpoint => string.Create(CultureInfo.InvariantCulture, $"http://127.0.0.1:{_server.Port}");

    /// <summary>How many connections came.</summary>
    public int Connections { get; private set; }

    /// <summary>All spans that arrived.</summary>
    public ConcurrentQueue<OtlpSpan> Spans { get; } = new();

    /// <summary>Names of all metrics that arrived, each with the service that it is of.</summary>
    public ConcurrentDictionary<string, string> Metrics { get; } = new(StringComparer.Ordinal);

    /// <summary>What arrived and was not understood.</summary>
    public ConcurrentQueue<string> Wrong { get; } = new();

    public void Dispose() => _server.Dispose();

    private async Task AnswerAsync(TcpClient client)
    {
        Connections++;
        try
        {
            var stream = client.GetStream();
            if (_hangs)
            {
                await Task.Delay(Timeout.Infinite, _server.End);
            }

            while (await RequestAsync(stream) is { } request)
            {
                Take(request.Path, request.Body);
                await stream.WriteAsync(
                    "HTTP/1.1 200 OK\r\nContent-Type: application/x-protobuf\r\nContent-Length: 0\r\n\r\n"u8.ToArray(), _server.End);
            }
        }
        catch (Exception e) when (!LoopbackServer.IsEnd(e))
        {
            Wrong.Enqueue(e.ToString());
        }
    }

    private async Task<(string Path, byte[] Body)?> RequestAsync(NetworkStream stream)
    {
        var head = new List<byte>();
        var one = new byte[1];
        while (head.Count < 4 || !head[^4..].SequenceEqual("\r\n\r\n"u8.ToArray()))
        {
            if (await stream.ReadAsync(one, _server.End) == 0)
            {
                return null;
            }

            head.Add(one[0]);
        }

        var lines = Encoding.ASCII.GetString([.. head]).Split("\r\n", StringSplitOptions.RemoveEmptyEntries);
        var length = lines.First(l => l.StartsWith("Content-Length:", StringComparison.OrdinalIgnoreCase)).Split(':')[1];
        var body = new byte[int.Parse(length, CultureInfo.InvariantCulture)];
        await stream.ReadExactlyAsync(body, _server.End);
        return (lines[0].Split(' ')[1], body);
    }

    private void Take(string path, byte[] body)
    {
        foreach (var resource in new OtlpFields(body).Messages(1))
        {
            var service = resource.Messages(1)
                .SelectMany(r => r.Messages(1))
                .FirstOrDefault(a => a.Text(1) == "service.name")?.Messages(2)
                .Single()
                .Text(1)
                ?? "";
            foreach (var item in resource.Messages(2).SelectMany(scope => scope.Messages(2)))
            {
                switch (path)
                {
                    case "/v1/traces":
                        Spans.Enqueue(new(service, item.Text(5), item.Hex(1), item.Hex(2), item.Hex(4), item.Value(7), item.Value(8)));
                        break;
                    case "/v1/metrics":
                        Metrics[item.Text(1)] = service;
                        break;
                    default:
                        Wrong.Enqueue(path);
                        break;
                }
            }
        }
    }
}
