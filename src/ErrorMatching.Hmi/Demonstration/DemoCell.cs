using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Hmi;

/// <summary>A cell to try out: the samples in their own folder, running in this process, with users whose password is public.</summary>
public sealed class DemoCell : IAsyncDisposable
{
    /// <summary>The password of all users.</summary>
    public const string Password = "demonstration";

    /// <summary>May view, release and reject.</summary>
    public const string Operator = "otto";

    /// <summary>May also approve and revert.</summary>
    public const string Setter = "anna";

    /// <summary>May do everything.</summary>
    public const string Administrator = "ada";

    /// <summary>Names of the sample files: nominal coordinates, the counterpart's program, a measured part.</summary>
    internal const string DrawingFile = "drawing.csv", ProgramFile = "counterpart.nc", PartFile = "part.csv";

    /// <summary>Names of a sample drawing of an outline, and of the program that cuts it.</summary>
    internal const string OutlineFile = "outline.dxf", OutlineProgramFile = "dovetail.nc";

    private readonly TimeProvider _clock;
    private readonly string _samples;
    private readonly CancellationTokenSource _stop = new();
    private Task _running = Task.CompletedTask;

    private DemoCell(CellSettings settings, TimeProvider clock, string samples) =>
        (Settings, _clock, _samples) = (settings, clock, samples);

    /// <summary>The configuration; a person must approve.</summary>
    public CellSettings Settings { get; }

    /// <summary>The folder that acts as the machine.</summary>
    public string MachineFolder => Settings.Machines[0].Transport.LocalFolder!;

    /// <summary>The folder of files to set up a job from: drawing, program and a measured part, and no similar files.</summary>
    public string SamplesFolder => SamplesIn(_samples);

    /// <summary>Creates the cell in a folder, with its users. It does not run yet.</summary>
    /// <param name="folder">An empty folder.</param>
    /// <param name="clock">The clock.</param>
    public static DemoCell Make(string folder, TimeProvider clock)
    {
        var samples = Path.Combine(AppContext.BaseDirectory, "samples");
        Copy(Path.Combine(samples, "cell"), Path.Combine(folder, "cell"));
        Copy(Path.Combine(samples, "complex-mating"), Path.Combine(folder, "complex-mating"));
        Copy(Path.Combine(samples, "surface-one"), Path.Combine(folder, "surface-one"));
        CopySetup(Path.Combine(samples, "complex-mating"), SamplesIn(folder));
        var (dovetail, setup) = (Path.Combine(samples, "dovetail"), SamplesIn(folder));
        File.Copy(Path.Combine(dovetail, "outline.dxf"), Path.Combine(setup, OutlineFile), overwrite: true);
        File.Copy(Path.Combine(dovetail, ProgramFile), Path.Combine(setup, OutlineProgramFile), overwrite: true);
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

    /// <summary>The key points of the drawing in the order of cutting, to set up a job from. The apex is left out: it is on the
    /// drawing, but it is not measured.</summary>
    internal static string Drawing(string theoretical) =>
        string.Concat(File.ReadLines(theoretical).Where(l => !l.StartsWith("3,", StringComparison.Ordinal)).Select(l => l + "\n"));

    /// <summary>Opens the cell created in a folder earlier.</summary>
    internal static DemoCell At(string folder, TimeProvider clock) =>
        new(CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json")), clock, folder);

    /// <summary>Runs the cell until it is disposed.</summary>
    public void Run() => _running = Task.Run(async () =>
    {
        using var store = CellStore.Open(Settings.Store, _clock, AuditKey.Open(Settings.KeysFolder));
        using var log = CellLog.Open(Settings.LogFolder);
        await new CellRunner(Settings, store, m => MachineFolders.Open(m, () => null), _clock, log).RunAsync(_stop.Token);
    });

    /// <summary>Drops a complete file of a measured part into the gauge's folder.</summary>
    /// <param name="serial">Its serial number.</param>
    /// <param name="spread">Largest distance of its points from the sample's, in mm; 0 gives the sample's part.</param>
    public void Deliver(int serial, double spread) =>
        Drop(0, "part", serial, DemoPart.Near(Sample("complex-mating", "part.csv"), serial, spread));

    /// <summary>Drops a measured counterpart that deviates from its part about as much as the sample's does, whatever was cut.</summary>
    /// <param name="serial">Serial number of the part.</param>
    /// <param name="spread">The spread that the part was delivered with.</param>
    public void DeliverCounterpart(int serial, double spread)
    {
        var part = Sample("complex-mating", "part.csv");
        var fits = DemoPart.Counterpart(DemoPart.Near(part, serial, spread), Sample("complex-mating", "counterpart-after.csv"), part);

        Drop(0, "counterpart", serial, DemoPart.Near(fits, ~serial, spread / 4));
    }

    /// <summary>Drops the measurement of a counterpart cut by a program.</summary>
    /// <param name="serial">Serial number of the part.</param>
    /// <param name="spread">Largest distance of its points from the program's, in mm.</param>
    /// <param name="cut">The key points as cut by the program, by label, mm.</param>
    public void DeliverCounterpart(int serial, double spread, IReadOnlyDictionary<string, Point2> cut) =>
        Drop(0, "counterpart", serial, DemoPart.Near(DemoPart.At(Sample("complex-mating", "counterpart-after.csv"), cut), ~serial, spread));

    /// <summary>Drops a complete file of a measured surface into its gauge's folder.</summary>
    /// <param name="serial">Its serial number.</param>
    /// <param name="spread">Largest distance of its points from the sample's, in mm; 0 gives the sample's surface.</param>
    public void DeliverSurface(int serial, double spread) =>
        Drop(1, "surface", serial, DemoPart.Near(Sample("surface-one", "measured.csv"), serial, spread));

    /// <summary>Reports that a machine has cut its piece, as the machine would.</summary>
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
        var (name, incoming) = (
            string.Create(CultureInfo.InvariantCulture, $"{piece}-{serial:0000}.csv"), Settings.Gauges[gauge].Incoming!);
        var outside = Path.Combine(incoming, "..", name);
        File.WriteAllText(outside, text);
        SharedFile.Replace(outside, Path.Combine(incoming, name));
    }

    private static string SamplesIn(string folder) => Path.Combine(folder, "samples");

    // Next to the job's own files, theoretical.csv and drawing.csv would be side by side, and users could not tell which one to use.
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
