using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A cell that anybody can play with: the samples in a folder of its own, running in this process, with users whose password is known.</summary>
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

    /// <summary>The samples' files by their names: coordinates as designed, the counterpart's program, a measured part.</summary>
    internal const string DrawingFile = "drawing.csv", ProgramFile = "counterpart.nc", PartFile = "part.csv";

    private readonly TimeProvider _clock;
    private readonly string _samples;
    private readonly CancellationTokenSource _stop = new();
    private Task _running = Task.CompletedTask;

    private DemoCell(CellSettings settings, TimeProvider clock, string samples) => (Settings, _clock, _samples) = (settings, clock, samples);

    /// <summary>The configuration: a person approves.</summary>
    public CellSettings Settings { get; }

    /// <summary>The folder that stands for the machine.</summary>
    public string MachineFolder => Settings.Machines[0].Transport.LocalFolder!;

    /// <summary>The folder of what its job is set up with: drawing, program and a measured part, and nothing that could be taken for one of them.</summary>
    public string SamplesFolder => SamplesIn(_samples);

    /// <summary>Puts the cell into a folder and makes its users. It does not run yet.</summary>
    /// <param name="folder">An empty folder.</param>
    /// <param name="clock">The clock.</param>
    public static DemoCell Make(string folder, TimeProvider clock)
    {
        var samples = Path.Combine(AppContext.BaseDirectory, "samples");
        Copy(Path.Combine(samples, "cell"), Path.Combine(folder, "cell"));
        Copy(Path.Combine(samples, "complex-mating"), Path.Combine(folder, "complex-mating"));
        Copy(Path.Combine(samples, "surface-one"), Path.Combine(folder, "surface-one"));
        CopySetup(Path.Combine(samples, "complex-mating"), SamplesIn(folder));
        var settings = CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json"));
        foreach (var made in settings.Gauges.Select(g => g.Incoming!).Concat(settings.Machines.Select(m => m.Transport.LocalFolder!)))
        {
            Directory.CreateDirectory(made);
        }

        using var store = CellStore.Open(settings.Store, clock, AuditKey.Open(settings.KeysFolder));
        var users = new UserBook(store, clock);
        users.AddFirst(Administrator, Password);
        users.Add(users.SignIn(Administrator, Password), Setter, Role.Setter, Password);
        users.Add(users.SignIn(Administrator, Password), Operator, Role.Operator, Password);
        return At(folder, clock);
    }

    /// <summary>The key points of the drawing in the order of cutting, to set a job up from: without the apex, which the drawing has and nobody measures.</summary>
    internal static string Drawing(string theoretical) => string.Concat(File.ReadLines(theoretical).Where(l => !l.StartsWith("3,", StringComparison.Ordinal)).Select(l => l + "\n"));

    /// <summary>The cell that was put into a folder before.</summary>
    internal static DemoCell At(string folder, TimeProvider clock) =>
        new(CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json")), clock, folder);

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
    public void Deliver(int serial, double spread) => Drop(0, "part", serial, DemoPart.Near(Sample("complex-mating", "part.csv"), serial, spread));

    /// <summary>Drops a measured counterpart that is about as far from a part as the sample's is from the sample's part, whatever was cut.</summary>
    /// <param name="serial">Serial number of the part.</param>
    /// <param name="spread">As it was delivered with.</param>
    public void DeliverCounterpart(int serial, double spread)
    {
        var part = Sample("complex-mating", "part.csv");
        var fits = DemoPart.Counterpart(DemoPart.Near(part, serial, spread), Sample("complex-mating", "counterpart-after.csv"), part);

        Drop(0, "counterpart", serial, DemoPart.Near(fits, ~serial, spread / 4));
    }

    /// <summary>Drops the measured counterpart that a program cut.</summary>
    /// <param name="serial">Serial number of the part.</param>
    /// <param name="spread">How far its points lie from where the program leads at most, in mm.</param>
    /// <param name="cut">Where the program leaves the key points, by label, mm.</param>
    public void DeliverCounterpart(int serial, double spread, IReadOnlyDictionary<string, Point2> cut) =>
        Drop(0, "counterpart", serial, DemoPart.Near(DemoPart.At(Sample("complex-mating", "counterpart-after.csv"), cut), ~serial, spread));

    /// <summary>Drops a measured surface into its gauge's folder, whole.</summary>
    /// <param name="serial">Its serial number.</param>
    /// <param name="spread">How far its points lie from those of the sample at most, in mm; 0 is the sample's surface.</param>
    public void DeliverSurface(int serial, double spread) => Drop(1, "surface", serial, DemoPart.Near(Sample("surface-one", "measured.csv"), serial, spread));

    /// <summary>Says what a machine says when the piece is cut.</summary>
    /// <param name="machine">Its name; null for the first one.</param>
    public void FinishPiece(string? machine = null)
    {
        var settings = machine is null ? Settings.Machines[0] : Settings.Machines.First(m => m.Name == machine);
        File.WriteAllText(Path.Combine(settings.Transport.LocalFolder!, settings.Slots[0].ReadyFile!), "");
    }

    /// <inheritdoc/>
    public async ValueTask DisposeAsync()
    {
        await _stop.CancelAsync();
        await _running;
        _stop.Dispose();
    }

    private string Sample(string sample, string file) => File.ReadAllText(Path.Combine(_samples, sample, file));

    private void Drop(int gauge, string piece, int serial, string text)
    {
        var (name, incoming) = (string.Create(CultureInfo.InvariantCulture, $"{piece}-{serial:0000}.csv"), Settings.Gauges[gauge].Incoming!);
        var outside = Path.Combine(incoming, "..", name);
        File.WriteAllText(outside, text);
        File.Move(outside, Path.Combine(incoming, name), overwrite: true);
    }

    private static string SamplesIn(string folder) => Path.Combine(folder, "samples");

    // Beside the job's own files theoretical.csv would stand next to drawing.csv, and nobody could tell which one is meant.
    private static void CopySetup(string from, string to)
    {
        Directory.CreateDirectory(to);
        File.WriteAllText(Path.Combine(to, DrawingFile), Drawing(Path.Combine(from, "theoretical.csv")));
        foreach (var name in new[] { ProgramFile, PartFile })
        {
            File.Copy(Path.Combine(from, name), Path.Combine(to, name), overwrite: true);
        }
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
