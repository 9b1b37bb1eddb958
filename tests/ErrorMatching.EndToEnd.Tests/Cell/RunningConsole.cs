using System.Diagnostics;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell that the built console runs in a process, which does not outlive its test.</summary>
internal sealed class RunningConsole : IDisposable
{
    private readonly Process _process;

    /// <summary>Starts it.</summary>
    /// <param name="shop">Where.</param>
    /// <param name="config">Its configuration, from there.</param>
    public RunningConsole(Workshop shop, string config)
    {
        _process = Process.Start(new ProcessStartInfo(ConsoleRun.Executable, ["cell", "run", config])
        {
            UseShellExecute = false,
            WorkingDirectory = shop.Folder,
            RedirectStandardError = true,
            RedirectStandardOutput = true,
        })!;
        _process.BeginErrorReadLine();
        _process.BeginOutputReadLine();
    }

    /// <summary>What it has used of the processors, in user and system mode, since it started.</summary>
    public TimeSpan ProcessorTime
    {
        get
        {
            _process.Refresh();
            return _process.TotalProcessorTime;
        }
    }

    /// <summary>Bytes of memory that it has at this moment.</summary>
    public long Memory
    {
        get
        {
            _process.Refresh();
            return _process.WorkingSet64;
        }
    }

    /// <summary>Ends it at once, and nothing of it has a say.</summary>
    public async Task KillAsync()
    {
        _process.Kill();
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken);
    }

    /// <summary>Asks it to end, by a signal where there are such, and waits for it.</summary>
    /// <returns>Its exit code.</returns>
    public async Task<int> EndAsync()
    {
        if (!ConsoleRun.HasSignals)
        {
            await KillAsync();
            return 0;
        }

        return await FireStop.Of(_process);
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _process.Kill();
        _process.WaitForExit();
        _process.Dispose();
    }
}
