using System.ComponentModel;
using System.Diagnostics;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Runs a program without a shell, in its own environment, with limits on time and output. On cancellation it is killed with all
/// its child processes.</summary>
internal static class ToolProcess
{
    private const int MostError = 16 << 10;

    // Variables that programs need to start and to be found. Omitted on purpose: proxies, agents, user configuration, languages.
    private static readonly string[] Inherited = [
        "PATH", "SystemRoot", "SystemDrive", "windir", "TEMP", "TMP", "TMPDIR", "ProgramData", "USERPROFILE"];

    /// <summary>Runs a program to its end.</summary>
    /// <exception cref="OperationCanceledException">Canceled; the program was killed.</exception>
    public static async Task<ToolResult> RunAsync(ToolRun run, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        using var process = new Process { StartInfo = StartOf(run) };
        try
        {
            process.Start();
        }
        catch (Win32Exception e)
        {
            return new ToolResult(ToolEnd.Missing, -1, [], e.Message);
        }

        using var late = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        using var tooMuch = new CancellationTokenSource();
        await using var endLate = late.Token.Register(() => Kill(process)).ConfigureAwait(false);
        await using var endTooMuch = tooMuch.Token.Register(() => Kill(process)).ConfigureAwait(false);
        late.CancelAfter(run.Limit);

        var output = ReadAsync(process.StandardOutput.BaseStream, run.MostOutput, tooMuch);
        var error = ReadAsync(process.StandardError.BaseStream, MostError, null);
        await FeedAsync(process, run.Input).ConfigureAwait(false);
        await process.WaitForExitAsync(CancellationToken.None).ConfigureAwait(false);
        var (said, complained) = (await output.ConfigureAwait(false), await error.ConfigureAwait(false));

        cancellation.ThrowIfCancellationRequested();
        var end = tooMuch.IsCancellationRequested ? ToolEnd.TooMuch : late.IsCancellationRequested ? ToolEnd.TimedOut : ToolEnd.Exited;
        return new ToolResult(end, process.ExitCode, said, Encoding.UTF8.GetString(complained));
    }

    private static ProcessStartInfo StartOf(ToolRun run)
    {
        var start = new ProcessStartInfo(run.Program, run.Arguments)
        {
            UseShellExecute = false,
            CreateNoWindow = true,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment.Clear();
        foreach (var name in Inherited)
        {
            if (Environment.GetEnvironmentVariable(name) is { } value)
                start.Environment[name] = value;
        }

        start.Environment["LC_ALL"] = "C";
        return start;
    }

    // A program that ended before it read all its input explains that by its exit code.
    private static async Task FeedAsync(Process process, ReadOnlyMemory<byte> input)
    {
        try
        {
            var stream = process.StandardInput.BaseStream;
            await stream.WriteAsync(input).ConfigureAwait(false);
            await stream.DisposeAsync().ConfigureAwait(false);
        }
        catch (IOException)
        {
        }
    }

    // Reads to the end, so that the program never blocks on output, but keeps only as much as wanted.
    private static async Task<byte[]> ReadAsync(Stream stream, long most, CancellationTokenSource? tooMuch)
    {
        using var kept = new MemoryStream();
        var buffer = new byte[16 << 10];
        int read;
        while ((read = await stream.ReadAsync(buffer).ConfigureAwait(false)) > 0)
        {
            var room = (int)Math.Min(read, most - kept.Length);
            kept.Write(buffer, 0, room);
            if (room < read && tooMuch is not null)
                await tooMuch.CancelAsync().ConfigureAwait(false);
        }

        return kept.ToArray();
    }

    // Runs in the canceling thread, so a program that has just exited must not cause an exception here.
    private static void Kill(Process process)
    {
        try
        {
            process.Kill(entireProcessTree: true);
        }
        catch (Exception e) when (e is InvalidOperationException or Win32Exception or AggregateException)
        {
        }
    }
}

/// <summary>A program's run: its input and its limits.</summary>
/// <param name="Program">Name of the program, found by PATH.</param>
/// <param name="Arguments">Its arguments, one by one; no shell reads them. No secrets: every user of the computer can see them.</param>
/// <param name="Input">Its standard input.</param>
/// <param name="Limit">Time limit; the program is killed after it.</param>
internal sealed record ToolRun(string Program, IReadOnlyList<string> Arguments, ReadOnlyMemory<byte> Input, TimeSpan Limit)
{
    /// <summary>Output limit; the program is killed above it.</summary>
    public long MostOutput { get; init; } = 4 << 20;
}

/// <summary>The result of a program's run.</summary>
/// <param name="End">How it ended.</param>
/// <param name="ExitCode">Its exit code, if it exited.</param>
/// <param name="Output">Its standard output.</param>
/// <param name="Error">The beginning of its standard error, at most 16 KB.</param>
internal sealed record ToolResult(ToolEnd End, int ExitCode, byte[] Output, string Error);

/// <summary>How a program's run ended.</summary>
internal enum ToolEnd
{
    /// <summary>It exited; see the exit code.</summary>
    Exited,

    /// <summary>Killed at the time limit.</summary>
    TimedOut,

    /// <summary>Killed because its output exceeded the limit.</summary>
    TooMuch,

    /// <summary>The program is not installed.</summary>
    Missing,
}
