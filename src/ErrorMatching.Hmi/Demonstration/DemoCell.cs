using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A cell that anybody can play with: the sample cell in a folder of its own, running in this process, with users whose password is known.</summary>
public sealed class DemoCell : IAsyncDisposable
{
    /// <summary>Everybody's password.</summary>
    public const string Password = "demonstration";

    /// <summary>May look, release and reject.</summary>
    public const string Operator = "otto";

    /// <summary>May approve and revert as well.</summary>
    public const string Setter = "anna";

    /// <summary>May do everything.</summary>
    public const string Administrator = "ada";

    private readonly TimeProvider _clock;
    private readonly string _part;
    private readonly CancellationTokenSource _stop = new();
    private Task _running = Task.CompletedTask;

    private DemoCell(CellSettings settings, TimeProvider clock, string part) => (Settings, _clock, _part) = (settings, clock, part);

    /// <summary>The configuration: that of the sample, but that a person approves.</summary>
    public CellSettings Settings { get; }

    /// <summary>The folder that stands for the machine.</summary>
    public string MachineFolder => ((FolderSettings)Settings.Machines[0].Transport).Folder;

    private string Incoming => Settings.Gauges[0].Incoming!;

    /// <summary>Puts the cell into a folder and makes its users. It does not run yet.</summary>
    /// <param name="folder">An empty folder.</param>
    /// <param name="clock">The clock.</param>
    public static DemoCell Make(string folder, TimeProvider clock)
    {
        var samples = Path.Combine(AppContext.BaseDirectory, "samples");
        Copy(Path.Combine(samples, "cell"), Path.Combine(folder, "cell"));
        Copy(Path.Combine(samples, "complex-mating"), Path.Combine(folder, "complex-mating"));
        var file = Path.Combine(folder, "cell", "cell.json");
        File.WriteAllText(file, File.ReadAllText(file).Replace("\"approve\": \"automatic\"", "\"approve\": \"person\"", StringComparison.Ordinal));
        var settings = CellSettingsReader.Read(file);
        Directory.CreateDirectory(settings.Gauges[0].Incoming!);
        Directory.CreateDirectory(((FolderSettings)settings.Machines[0].Transport).Folder);
        using var store = CellStore.Open(settings.Store, clock, AuditKey.Open(settings.KeysFolder));
        var users = new UserBook(store, clock);
        users.AddFirst(Administrator, Password);
        users.Add(users.SignIn(Administrator, Password), Setter, Role.Setter, Password);
        users.Add(users.SignIn(Administrator, Password), Operator, Role.Operator, Password);
        return At(folder, clock);
    }

    /// <summary>The cell that was put into a folder before.</summary>
    internal static DemoCell At(string folder, TimeProvider clock) =>
        new(CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json")), clock, File.ReadAllText(Path.Combine(folder, "complex-mating", "part.csv")));

    /// <summary>Runs the cell until it is disposed.</summary>
    public void Run() => _running = Task.Run(async () =>
    {
        using var store = CellStore.Open(Settings.Store, _clock, AuditKey.Open(Settings.KeysFolder));
        using var log = CellLog.Open(Settings.LogFolder);
        await new CellRunner(Settings, store, m => MachineFolders.Open(m, () => null), _clock, log).RunAsync(_stop.Token);
    });

    /// <summary>Drops a measured part into the gauge's folder, whole.</summary>
    /// <param name="serial">Its serial number.</param>
    /// <param name="spread">How far its points lie from those of the sample at most, in mm; 0 is the sample's part.</param>
    public void Deliver(int serial, double spread)
    {
        var name = string.Create(CultureInfo.InvariantCulture, $"part-{serial:0000}.csv");
        var outside = Path.Combine(Incoming, "..", name);
        File.WriteAllText(outside, DemoPart.Near(_part, serial, spread));
        File.Move(outside, Path.Combine(Incoming, name), overwrite: true);
    }

    /// <summary>Says what the machine says when the piece is cut.</summary>
    public void FinishPiece() => File.WriteAllText(Path.Combine(MachineFolder, Settings.Machines[0].Slots[0].ReadyFile!), "");

    /// <inheritdoc/>
    public async ValueTask DisposeAsync()
    {
        await _stop.CancelAsync();
        await _running;
        _stop.Dispose();
    }

    private static void Copy(string from, string to)
    {
        Directory.CreateDirectory(to);
        foreach (var file in Directory.EnumerateFiles(from))
        {
            File.Copy(file, Path.Combine(to, Path.GetFileName(file)), overwrite: true);
        }
    }
}
