using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Cell.Tests;

/// <summary>A broker on a port of this computer that answers the packets of a publisher, or withholds an answer. Source of the packets:
/// MQTT 5.0, section 3.</summary>
internal sealed class BrokerDouble : IAsyncDisposable
{
    private const int Connect = 1, Publish = 3, Release = 6, Ping = 12;
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly Task _serving;

    public BrokerDouble()
    {
        _listener.Start();
        _serving = ServeAsync();
    }

    /// <summary>The settings of a cell that publishes to it.</summary>
    public EventSettings Settings => new(
        "127.0.0.1", ((IPEndPoint)_listener.LocalEndpoint).Port, "plant/steps", null, null, false, null, null);

    /// <summary>Identities of the messages that came in, in order, also those that came again.</summary>
    public ConcurrentQueue<string> Heard { get; } = new();

    /// <summary>The last message of what waits: its topic, whether the broker is to keep it, and its text.</summary>
    public (string Topic, bool IsKept, string Text)? Announced { get; private set; }

    /// <summary>So many messages are received (PUBREC); later ones get no answer.</summary>
    public int MostReceived { get; set; } = int.MaxValue;

    /// <summary>So many messages are completed (PUBCOMP); later ones are received only.</summary>
    public int MostCompleted { get; set; } = int.MaxValue;

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync();
        await _serving;
        _listener.Stop();
        _end.Dispose();
    }

    private async Task ServeAsync()
    {
        var talks = new List<Task>();
        try
        {
            while (true)
                talks.Add(TalkAsync(await _listener.AcceptTcpClientAsync(_end.Token)));
        }
        catch (Exception e) when (e is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            await Task.WhenAll(talks);
        }
    }

    private async Task TalkAsync(TcpClient client)
    {
        var (received, completed) = (0, 0);
        try
        {
            using (client)
            {
                var stream = client.GetStream();
                while (await PacketAsync(stream) is var (first, body))
                {
                    var kind = first >> 4;
                    if (kind == Publish && (first & 6) == 0)
                    {
                        var (topic, message) = Read(body, 0);
                        Announced = (topic, (first & 1) == 1, message);
                        continue;
                    }

                    byte[]? answer = kind switch
                    {
                        Connect => [0x20, 3, 0, 0, 0],
                        Publish => ++received <= MostReceived ? [0x50, 2, .. Hear(body)] : Unanswered(body),
                        Release => ++completed <= MostCompleted ? [0x70, 2, .. body[..2]] : null,
                        Ping => [0xD0, 0],
                        _ => null,
                    };
                    if (answer is not null) await stream.WriteAsync(answer, _end.Token);
                }
            }
        }
        catch (Exception e) when (e is IOException or OperationCanceledException)
        {
            // The cell has gone, or the test ends.
        }
    }

    private byte[]? Unanswered(byte[] body)
    {
        Hear(body);
        return null;
    }

    // The number of the packet.
    private byte[] Hear(byte[] body)
    {
        var (topic, text) = Read(body, 2);
        using var message = JsonDocument.Parse(text);
        Heard.Enqueue(message.RootElement.GetProperty("id").GetString()!);
        return body[(2 + topic.Length)..(4 + topic.Length)];
    }

    // After the topic comes the number, if there is one; then properties, whose length is one byte here, and the message.
    private static (string Topic, string Message) Read(byte[] body, int bytesOfNumber)
    {
        var end = 2 + BinaryPrimitives.ReadUInt16BigEndian(body);
        var properties = end + bytesOfNumber;
        return (Encoding.ASCII.GetString(body, 2, end - 2), Encoding.UTF8.GetString(body.AsSpan(properties + 1 + body[properties])));
    }

    private async Task<(int First, byte[] Body)?> PacketAsync(NetworkStream stream)
    {
        var one = new byte[1];
        if (await stream.ReadAsync(one, _end.Token) == 0) return null;
        int first = one[0];
        var (length, shift) = (0, 0);
        do
        {
            await stream.ReadExactlyAsync(one, _end.Token);
            length |= (one[0] & 0x7F) << shift;
            shift += 7;
        }
        while (one[0] > 0x7F);
        var body = new byte[length];
        await stream.ReadExactlyAsync(body, _end.Token);
        return (first, body);
    }
}
