using System.Net.Sockets;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>Who listens at the port of an SSH server and is none: it is left in time, whatever it says.</summary>
public sealed class HostileSshTests
{
    private static readonly byte[] Banner = "SSH-2.0-Hostile\r\n"u8.ToArray();

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public Task Silence_ends_with_the_time_limit() => FailsAsync(TransportError.Slow, 0.3, (_, end) => Task.Delay(-1, end));

    [Fact]
    public Task A_banner_without_a_key_ends_with_the_time_limit() => FailsAsync(TransportError.Slow, 0.3, async (stream, end) =>
    {
        await stream.WriteAsync(Banner, end);
        await Task.Delay(-1, end);
    });

    [Fact]
    public Task Drops_of_a_banner_end_with_the_time_limit() => FailsAsync(TransportError.Slow, 0.3, async (stream, end) =>
    {
        while (true)
        {
            await stream.WriteAsync("x"u8.ToArray(), end);
            await Task.Delay(10, end);
        }
    });

    [Fact]
    public Task Endless_lines_are_left() => FailsAsync(TransportError.Away, 60, async (stream, end) =>
    {
        while (true)
            await stream.WriteAsync("Welcome!\r\n"u8.ToArray(), end);
    });

    [Fact]
    public Task A_line_without_an_end_is_left() => FailsAsync(TransportError.Away, 60, async (stream, end) =>
    {
        while (true)
            await stream.WriteAsync(Encoding.ASCII.GetBytes(new string('x', 1000)), end);
    });

    [Fact]
    public Task A_packet_that_is_too_large_is_left() => FailsAsync(TransportError.Away, 60, async (stream, end) =>
    {
        await stream.WriteAsync(Banner, end);
        await stream.WriteAsync(new byte[] { 0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0 }, end);
        await Task.Delay(-1, end);
    });

    [Fact]
    public async Task Garbage_is_left()
    {
        for (var n = 0; n < 20; n++)
        {
            var garbage = new byte[2000];
            new Random(n).NextBytes(garbage);

            // A length that is taken, so that what follows is looked at.
            (garbage[0], garbage[1], garbage[2], garbage[4]) = (0, 0, (byte)(n % 4), 4);
            await FailsAsync(TransportError.Away, 60, async (stream, end) =>
            {
                await stream.WriteAsync(Banner, end);
                await stream.WriteAsync(garbage, end);
            });
        }
    }

    [Fact]
    public Task Another_protocol_is_left() => FailsAsync(TransportError.Away, 60, async (stream, end) =>
        await stream.WriteAsync("SSH-1.5-Old\r\n"u8.ToArray(), end));

    private static async Task FailsAsync(TransportError error, double seconds, Func<NetworkStream, CancellationToken, Task> say)
    {
        LoopbackServer? server = null;
        server = new(async client =>
        {
            using (client)
            {
                try
                {
                    await say(client.GetStream(), server!.End);
                }
                catch (Exception e) when (LoopbackServer.IsEnd(e))
                {
                    // It hung up.
                }
            }
        });
        using var running = server;
        server.Start();
        var settings = new SftpSettings("127.0.0.1", server.Port, "cell", "programs", CellFolder.HostKey, null);
        using var folder = settings.Open("mill", () => "sesame", TimeSpan.FromSeconds(seconds));
        var failure = await Assert.ThrowsAsync<TransportException>(() => folder.ListAsync(Token));
        Assert.True(error == failure.Error, $"{error} expected: {failure.Error}: {failure.Message}");
        Assert.DoesNotContain("sesame", failure.ToString(), StringComparison.Ordinal);
    }
}
