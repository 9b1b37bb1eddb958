using System.Diagnostics;
using System.Text;

namespace ErrorMatching.Peers.Tests;

/// <summary>A server program of a test on a loopback port of its own, with a folder for its files;
/// ended with all its sessions when disposed.</summary>
internal sealed class Daemon : IDisposable
{
    private const int Tries = 20;
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(2);
    private readonly string _folder;
    private readonly StringBuilder _said = new();
    private Process? _process;

    /// <summary>Starts it and waits until it listens.</summary>
    /// <param name="program">The program's path.</param>
    /// <param name="folder">Its files, deleted in the end.</param>
    /// <param name="arguments">Its arguments for a port.</param>
    public Daemon(string program, string folder, Func<int, IEnumerable<string>> arguments)
    {
        _folder = folder;

        // Another program may have the port, or take it before this one does. Then the server ends, and gets another.
        for (var tries = 0; !TryStart(program, arguments); tries++)
        {
            if (tries < Tries)
                continue;
            Dispose();
            lock (_said)
                Assert.Fail($"{program} does not listen at any port: {_said}");
        }
    }

    public int Port { get; private set; }

    /// <summary>A port below those that Linux gives to connections (ip_local_port_range) and below vsftpd's for data:
    /// it stays free while a server is started again.</summary>
    public static int AnyPort() => Random.Shared.Next(10_000, 20_000);

    /// <summary>The path of a server program, or null if it is not installed. System programs are not in every user's PATH.</summary>
    public static string? Find(string name) => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Concat(["/usr/sbin", "/sbin"])
        .Select(f => Path.Combine(f, name))
        .FirstOrDefault(File.Exists);

    /// <summary>Skips the current test where a program is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded(string name, string package)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Whose a port is, is read from /proc.");
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
            Assert.True(Find(name) is not null, $"{name} is missing: install the package {package}.");
        Assert.SkipUnless(Find(name) is not null, $"{name} is not installed (package {package}).");
    }

    public void Dispose()
    {
        End();
        Directory.Delete(_folder, recursive: true);
    }

    private bool TryStart(string program, Func<int, IEnumerable<string>> arguments)
    {
        End();
        Port = AnyPort();
        var start = new ProcessStartInfo(program, arguments(Port))
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            RedirectStandardInput = true
        };
        _process = Process.Start(start)!;
        _process.OutputDataReceived += Keep;
        _process.ErrorDataReceived += Keep;
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
        var since = Stopwatch.StartNew();
        while (!ProcessTable.Listens(_process.Id, Port))
        {
            if (_process.HasExited || since.Elapsed > Limit)
                return false;
            Thread.Sleep(10);
        }

        return true;
    }

    // A session that still ends would write into the folder while it is deleted.
    private void End()
    {
        if (_process is null)
            return;
        var sessions = ProcessTable.Descendants(_process.Id).Select(p => p.Id).ToArray();
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
        _process = null;
        Assert.True(ProcessTable.EndAsync(sessions).GetAwaiter().GetResult(), "A session of the server does not end.");
    }

    private void Keep(object sender, DataReceivedEventArgs line)
    {
        lock (_said)
            _said.AppendLine(line.Data);
    }
}
