using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The demonstration: a cell in a temporary folder that is deleted at the end, and its simulated day.</summary>
public sealed class Demonstration : IDisposable
{
    private readonly string _folder;
    private readonly DemoCell _cell;
    private readonly CancellationTokenSource _end = new();
    private readonly Task _day;

    private Demonstration(string folder, TimeProvider clock)
    {
        _folder = folder;
        _cell = DemoCell.Make(folder, clock);
        _cell.Run();
        _day = new DemoDay(_cell, clock).RunAsync(_end.Token);
    }

    public CellSettings Settings => _cell.Settings;

    /// <summary>The folder of files to set up its job from.</summary>
    public string SamplesFolder => _cell.SamplesFolder;

    public static Demonstration Start(TimeProvider clock) => new(Directory.CreateTempSubdirectory("errormatch-station-").FullName, clock);

    /// <inheritdoc/>
    public void Dispose()
    {
        _end.Cancel();
        _day.GetAwaiter().GetResult();

        // Off the UI thread, which is blocked here: a continuation of the cell must not wait for it.
        Task.Run(async () => await _cell.DisposeAsync()).GetAwaiter().GetResult();
        _end.Dispose();
        Directory.Delete(_folder, recursive: true);
    }
}
