using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The demonstration: a cell in a folder that is removed behind it, and its day.</summary>
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

    /// <summary>The cell's configuration.</summary>
    public CellSettings Settings => _cell.Settings;

    /// <summary>The folder of what its job is set up with.</summary>
    public string SamplesFolder => _cell.SamplesFolder;

    /// <summary>Starts it.</summary>
    public static Demonstration Start(TimeProvider clock) => new(Directory.CreateTempSubdirectory("errormatch-station-").FullName, clock);

    /// <inheritdoc/>
    public void Dispose()
    {
        _end.Cancel();
        _day.GetAwaiter().GetResult();

        // Away from the screen's thread, which stands still here: what the cell awaits must not wait for it.
        Task.Run(async () => await _cell.DisposeAsync()).GetAwaiter().GetResult();
        _end.Dispose();
        Directory.Delete(_folder, recursive: true);
    }
}
