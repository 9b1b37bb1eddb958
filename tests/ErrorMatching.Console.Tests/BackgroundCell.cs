namespace ErrorMatching.Console.Tests;

/// <summary>A cell that is run in this process, beside a test.</summary>
internal sealed class BackgroundCell : IDisposable
{
    private readonly CancellationTokenSource _stop = new();
    private readonly StringWriter _output = new() { NewLine = "\n" };
    private readonly Task<int> _run;

    private BackgroundCell(string config) =>
        _run = Task.Run(() => Application.Run(
            ["cell", "run", config], new Terminal(_output, TextWriter.Null, HasColor: false), _stop.Token));

    /// <summary>Starts a cell and waits until it says that it runs.</summary>
    public static async Task<BackgroundCell> Start(string config)
    {
        var cell = new BackgroundCell(config);
        await Until(
            () => cell._run.IsCompleted
                || Shell.Run("cell", "status", config, "--json").Output.Contains("\"running\": true", StringComparison.Ordinal));
        Assert.False(cell._run.IsCompleted, cell._output.ToString());
        return cell;
    }

    /// <summary>Tells it to stop.</summary>
    /// <returns>What it ends with.</returns>
    public async Task<(int Exit, string Output)> Stop()
    {
        await _stop.CancelAsync();
        var exit = await _run.WaitAsync(TimeSpan.FromMinutes(1));
        return (exit, _output.ToString());
    }

    /// <summary>Waits until something holds.</summary>
    public static async Task Until(Func<bool> holds)
    {
        for (var i = 0; i < 600; i++)
        {
            if (holds())
            {
                return;
            }

            await Task.Delay(50);
        }

        Assert.Fail("It did not come about within 30 s.");
    }

    public void Dispose()
    {
        _stop.Cancel();
        Assert.True(_run.Wait(TimeSpan.FromMinutes(1)));
        _stop.Dispose();
        _output.Dispose();
    }
}
