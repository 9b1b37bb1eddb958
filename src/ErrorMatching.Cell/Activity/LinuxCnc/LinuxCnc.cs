using System.Globalization;
using System.Net.Sockets;
using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Asks LinuxCNC through its line server (linuxcncrsh(1), protocol 1.1). Only <c>get</c> is ever sent.</summary>
internal sealed class LinuxCnc(LinuxCncSettings settings) : MachineStateSource(settings.Address, settings.Timeout)
{
    private const int MostBytes = 8192;
    private const int MostLines = 6;
    private const int Rounds = 3;

    // The password that every installation has unless it sets another. Reading needs none, so a refusal of it does not matter.
    private const string Hello = "hello EMC errormatch 1.0";

    protected override async Task<MachineState> AnswerAsync(CancellationToken cancellation)
    {
        using var client = new TcpClient { NoDelay = true };
        await client.ConnectAsync(settings.Host, settings.Port, cancellation).ConfigureAwait(false);
        var lines = new Lines(client.GetStream(), Wrong);
        await lines.AskAsync(Hello, "HELLO", cancellation).ConfigureAwait(false);
        var isStopped = await lines.AskAsync("get estop", "ESTOP", cancellation).ConfigureAwait(false) switch
        {
            "ON" => true,
            "OFF" => false,
            var other => throw Wrong($"ESTOP {other}"),
        };

        // The status is read on both sides of the program, so that both belong together, and last, so that it is as new as possible.
        for (var round = 1; round <= Rounds; round++)
        {
            var before = await lines.AskAsync("get program_status", "PROGRAM_STATUS", cancellation).ConfigureAwait(false);
            var program = await lines.AskAsync("get program", "PROGRAM", cancellation).ConfigureAwait(false);
            var status = await lines.AskAsync("get program_status", "PROGRAM_STATUS", cancellation).ConfigureAwait(false);
            if (status == before)
            {
                return new(isStopped ? MachineActivity.Alarm : ActivityOf(status), program is "NONE" ? [] : [Name(program)], null);
            }
        }

        throw Wrong("its status changes with every question");
    }

    private MachineActivity ActivityOf(string status) => status switch
    {
        "IDLE" => MachineActivity.Idle,
        "RUNNING" => MachineActivity.Running,
        "PAUSED" => MachineActivity.Held,
        _ => throw Wrong($"PROGRAM_STATUS {status}"),
    };

    private sealed class Lines(NetworkStream stream, Func<string, StateException> wrong)
    {
        private readonly byte[] _buffer = new byte[MostBytes];
        private int _count;
        private int _read;

        /// <summary>Sends a line and reads the answer that begins with a word. The server may repeat the question first.</summary>
        public async Task<string> AskAsync(string question, string word, CancellationToken cancellation)
        {
            await stream.WriteAsync(Encoding.ASCII.GetBytes(question + "\r\n"), cancellation).ConfigureAwait(false);
            for (var i = 0; i < MostLines; i++)
            {
                var line = await ReadAsync(cancellation).ConfigureAwait(false);
                if (line.StartsWith(word + " ", StringComparison.OrdinalIgnoreCase))
                    return line[(word.Length + 1)..].Trim();
                if (line.Length > 0 && !line.Equals(question, StringComparison.OrdinalIgnoreCase))
                    throw wrong(line);
            }

            throw wrong($"no {word}");
        }

        private async Task<string> ReadAsync(CancellationToken cancellation)
        {
            while (true)
            {
                var end = Array.IndexOf(_buffer, (byte)'\n', _read, _count - _read);
                if (end >= 0)
                {
                    var line = Encoding.UTF8.GetString(_buffer, _read, end - _read).TrimEnd('\r');
                    _read = end + 1;
                    return line;
                }

                if (_count == MostBytes)
                    throw wrong($"more than {MostBytes} bytes");
                var read = await stream.ReadAsync(_buffer.AsMemory(_count), cancellation).ConfigureAwait(false);
                if (read == 0)
                    throw new IOException("the connection was closed");
                _count += read;
            }
        }
    }
}

/// <summary>LinuxCNC's line server, <c>linuxcncrsh</c>. The cell only reads, which needs no password.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Its port.</param>
internal sealed record LinuxCncSettings(string Host, int Port) : StateSettings
{
    private const int UsualPort = 5007;

    /// <inheritdoc/>
    public override string Address => string.Create(CultureInfo.InvariantCulture, $"linuxcncrsh at {Host}:{Port}");

    public static LinuxCncSettings Read(JsonItem item) =>
        new(item["host"].Text, (int)(item.Find("port")?.Number ?? UsualPort));

    internal override MachineStateSource Open(TimeProvider clock) => new LinuxCnc(this);
}
