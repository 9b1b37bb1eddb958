using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace ErrorMatching.Peers.Tests;

/// <summary>A server program of a test on a loopback port of its own, with a folder for its files; ended with all its sessions when disposed.</summary>
internal sealed class Daemon : IDisposable
{
    private readonly Process _process;
    private readonly string _folder;

    /// <summary>Starts it and waits until it takes connections.</summary>
    /// <param name="program">The program's path.</param>
    /// <param name="folder">Its files, deleted in the end.</param>
    /// <param name="port">The port that its configuration names.</param>
    /// <param name="arguments">Its arguments.</param>
    public Daemon(string program, string folder, int port, params string[] arguments)
    {
        _folder = folder;
        var start = new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true, RedirectStandardInput = true };
        _process = Process.Start(start)!;
        var said = new System.Text.StringBuilder();
        void Keep(object sender, DataReceivedEventArgs line)
        {
            lock (said)
                said.AppendLine(line.Data);
        }

        _process.OutputDataReceived += Keep;
        _process.ErrorDataReceived += Keep;
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
        var since = Stopwatch.StartNew();
        while (!Answers(port))
        {
            if (_process.HasExited || since.Elapsed > TimeSpan.FromSeconds(20))
            {
                Dispose();
                lock (said)
                    Assert.Fail($"{program} does not listen at port {port}: {said}");
            }

            Thread.Sleep(20);
        }
    }

    /// <summary>The path of a server program, or null if it is not installed. System programs are not in every user's PATH.</summary>
    public static string? Find(string name) => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Concat(["/usr/sbin", "/sbin"])
        .Select(f => Path.Combine(f, name))
        .FirstOrDefault(File.Exists);

    /// <summary>Skips the current test where a program is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded(string name, string package)
    {
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
            Assert.True(Find(name) is not null, $"{name} is missing: install the package {package}.");
        Assert.SkipUnless(Find(name) is not null, $"{name} is not installed (package {package}).");
    }

    /// <summary>A port that nobody listens at.</summary>
    public static int FreePort()
    {
        using var probe = new TcpListener(IPAddress.Loopback, 0);
        probe.Start();
        return ((IPEndPoint)probe.LocalEndpoint).Port;
    }

    public void Dispose()
    {
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    private static bool Answers(int port)
    {
        using var client = new TcpClient();
        try
        {
            client.Connect(IPAddress.Loopback, port);
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }
}
