using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>A whole LinuxCNC control of the tests' own, from Debian's package linuxcnc-uspace, without a screen and without real time, in
/// name spaces of its own. Its line server is relayed to a port of this computer.</summary>
public sealed class LinuxCncControl : IAsyncLifetime
{
    private const string Package = "linuxcnc-uspace";
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(6);
    private static readonly string[] Files = ["control.sh", "control.ini", "control.hal", "relay.py", "touch.py", "slot.json"];
    private static readonly string[] Programs = ["milltask", "linuxcncrsh", "halcmd", "halsampler", "unshare", "ip", "python3"];
    private readonly TcpListener _relay = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly StringBuilder _said = new();
    private Process? _process;
    private Task _relaying = Task.CompletedTask;
    private TcpClient? _line;
    private StreamReader? _answers;

    /// <summary>The control's own folder.</summary>
    public string Home { get; } = Directory.CreateTempSubdirectory("errormatch-control-").FullName;

    /// <summary>The folder of its programs.</summary>
    public string Nc => Path.Combine(Home, "nc");

    /// <summary>The port of its line server.</summary>
    public int Port { get; private set; }

    /// <summary>The path that its servo loop commanded so far, from <c>halsampler</c>: number, x, y, z in each line.</summary>
    public string Sampled => Path.Combine(Home, "path.txt");

    /// <summary>Skips the current test where the control cannot run, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded()
    {
        var missing = !OperatingSystem.IsLinux() ? "LinuxCNC runs on Linux only"
            : Programs.FirstOrDefault(p => Daemon.Find(p) is null) is { } program ? $"{program} is not installed (package {Package})"
            : Environment.UserName != "root" ? "Name spaces need root"
            : null;
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
            Assert.True(missing is null, missing);
        Assert.SkipWhen(missing is not null, missing ?? "");
    }

    public async ValueTask InitializeAsync()
    {
        if (!OperatingSystem.IsLinux() || Programs.Any(p => Daemon.Find(p) is null) || Environment.UserName != "root")
            return;
        Directory.CreateDirectory(Nc);
        foreach (var file in Files)
            File.Copy(Repository.PathTo("tests", "ErrorMatching.Peers.Tests", "Control", file), Path.Combine(Home, file));

        // Its real-time part runs as nobody. It needs little of a processor, but at once: beside other tests, everything takes minutes
        // otherwise.
        File.SetUnixFileMode(Home, (UnixFileMode)0b111_111_111 | UnixFileMode.StickyBit);
        _process = Process.Start(new ProcessStartInfo(
            "nice",
            [
                "-n", "-39", "unshare", "--pid", "--fork", "--ipc", "--net", "--mount-proc", "--kill-child",
                "bash", Path.Combine(Home, "control.sh"), Home,
            ])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        })!;
        _process.OutputDataReceived += Keep;
        _process.ErrorDataReceived += Keep;
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
        await UntilAsync(() => Task.FromResult(File.Exists(Path.Combine(Home, "ready"))));
        _relay.Start();
        Port = ((IPEndPoint)_relay.LocalEndpoint).Port;
        _relaying = RelayAsync();
        _line = new TcpClient { NoDelay = true };
        await _line.ConnectAsync(IPAddress.Loopback, Port);
        _answers = new StreamReader(_line.GetStream(), Encoding.ASCII);
        Assert.StartsWith("HELLO ACK", await AskAsync("hello EMC tests 1.0"), StringComparison.Ordinal);
        await TellAsync("echo off");
        await TellAsync("verbose on");
        string[] settings = ["enable EMCTOO", "estop off", "machine on", "mode manual", "home 0", "home 1", "home 2", "mode auto"];
        foreach (var setting in settings)
            await SetAsync(setting);
        await UntilAsync(async () =>
            (await AskAsync("get joint_homed")).Contains("YES YES YES", StringComparison.Ordinal)
            && await AskAsync("get mode") == "MODE AUTO");
    }

    /// <summary>Sends a setting and waits for its acknowledgement.</summary>
    public async Task SetAsync(string setting) =>
        Assert.EndsWith(" ACK", await AskAsync("set " + setting), StringComparison.Ordinal);

    /// <summary>IDLE, RUNNING or PAUSED.</summary>
    public async Task<string> StatusAsync() => (await AskAsync("get program_status")).Split(' ')[^1];

    /// <summary>The selected program's path, or NONE.</summary>
    public async Task<string> ProgramAsync() => (await AskAsync("get program")).Split(' ', 2)[^1];

    /// <summary>Waits until the control reports a status.</summary>
    public Task UntilStatusAsync(string status) => UntilAsync(async () => await StatusAsync() == status);

    /// <summary>How often the control has said something since it was started.</summary>
    public int TimesSaid(string words)
    {
        lock (_said)
            return _said.ToString().Split(words).Length - 1;
    }

    /// <summary>Selects a program of <see cref="Nc"/>.</summary>
    public async Task OpenAsync(string program)
    {
        await SetAsync("open " + Path.Combine(Nc, program));
        await UntilAsync(async () => await ProgramAsync() == Path.Combine(Nc, program));
    }

    /// <summary>Starts the selected program and waits until it runs.</summary>
    public async Task RunAsync()
    {
        await SetAsync("run");
        await UntilStatusAsync("RUNNING");
    }

    /// <summary>The place of the tool.</summary>
    public async Task<(double X, double Y, double Z)> PlaceAsync()
    {
        var answer = await AskAsync("get abs_act_pos");
        var numbers = answer.Split(' ')[1..].Select(n => double.Parse(n, CultureInfo.InvariantCulture)).ToArray();
        return (numbers[0], numbers[1], numbers[2]);
    }

    /// <summary>The last cut at a depth, in the sampler's file; its writer keeps some tenths of a second back.</summary>
    public async Task<List<(double X, double Y)>> LastCutAsync(double depth)
    {
        List<(double X, double Y)> cut = [];
        await UntilAsync(async () =>
        {
            cut = [];
            var isDeep = false;
            await using var file = new FileStream(Sampled, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
            using var lines = new StreamReader(file, Encoding.ASCII);
            while (await lines.ReadLineAsync(CancellationToken.None) is { } line)
            {
                Assert.DoesNotContain("overrun", line, StringComparison.Ordinal);

                // Each line ends with a space: half of one is read again.
                if (line.Split(' ') is not [_, var x, var y, var z, ""])
                    continue;
                var wasDeep = isDeep;
                isDeep = Number(z) < depth + 1e-6;
                if (isDeep && !wasDeep)
                    cut.Clear();
                if (isDeep)
                    cut.Add((Number(x), Number(y)));
            }

            return cut.Count > 0 && !isDeep;
        });
        return cut;

        static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
    }

    /// <summary>Waits until something holds.</summary>
    public async Task UntilAsync(Func<Task<bool>> holds)
    {
        var begun = Stopwatch.GetTimestamp();
        while (!await holds())
        {
            if (_process!.HasExited || Stopwatch.GetElapsedTime(begun) > Limit)
            {
                lock (_said)
                    Assert.Fail($"The control does not come to it: {_said}");
            }

            await Task.Delay(20);
        }
    }

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync();
        _answers?.Dispose();
        _line?.Dispose();
        await _relaying;
        _relay.Dispose();
        if (_process is not null)
        {
            // The first process of the name space takes all others with it.
            _process.Kill(entireProcessTree: true);
            await _process.WaitForExitAsync();
            _process.Dispose();
        }

        _end.Dispose();
        Directory.Delete(Home, recursive: true);
    }

    private async Task TellAsync(string setting)
    {
        await _line!.GetStream().WriteAsync(Encoding.ASCII.GetBytes($"set {setting}\r\n"));
        if (setting == "echo off")
            Assert.Equal("set echo off", await ReadAsync());
        else
            Assert.EndsWith("ACK", await ReadAsync(), StringComparison.Ordinal);
    }

    private async Task<string> AskAsync(string question)
    {
        await _line!.GetStream().WriteAsync(Encoding.ASCII.GetBytes(question + "\r\n"));
        return await ReadAsync();
    }

    private async Task<string> ReadAsync()
    {
        using var late = new CancellationTokenSource(Limit);
        string? line;
        do
            line = (await _answers!.ReadLineAsync(late.Token) ?? throw new EndOfStreamException("The control closed its line."));
        while (line.Length == 0);
        return line;
    }

    private async Task RelayAsync()
    {
        var talks = new List<Task>();
        try
        {
            while (true)
                talks.Add(RelayAsync(await _relay.AcceptTcpClientAsync(_end.Token)));
        }
        catch (Exception e) when (e is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            await Task.WhenAll(talks);
        }
    }

    private async Task RelayAsync(TcpClient client)
    {
        using (client)
        {
            client.NoDelay = true;
            using var inside = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
            try
            {
                await inside.ConnectAsync(new UnixDomainSocketEndPoint(Path.Combine(Home, "line")), _end.Token);
                await using var line = new NetworkStream(inside);
                var there = client.GetStream().CopyToAsync(line, _end.Token);
                var back = line.CopyToAsync(client.GetStream(), _end.Token);
                await Task.WhenAny(there, back);
                inside.Shutdown(SocketShutdown.Both);
                client.Close();
                await Task.WhenAll(there, back);
            }
            catch (Exception e) when (e is IOException or SocketException or OperationCanceledException or ObjectDisposedException)
            {
                // One of the two has gone.
            }
        }
    }

    private void Keep(object sender, DataReceivedEventArgs e)
    {
        lock (_said)
            _said.AppendLine(e.Data);
    }
}
