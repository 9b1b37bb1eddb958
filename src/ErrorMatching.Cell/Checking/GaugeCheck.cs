namespace ErrorMatching.Cell;

/// <summary>Examines the files waiting at gauges and finds the job of each.</summary>
internal sealed class GaugeCheck(CellSettings settings, IReadOnlyList<CheckedMachine> machines)
{
    private const int MostLookedAt = 50;
    private readonly Recognizer _recognizer = new(settings);

    public CheckedGauge Of(GaugeSettings gauge, CancellationToken cancellation) =>
        gauge.Incoming is { } folder ? OfFolder(gauge, folder, cancellation) : OfMachine(gauge);

    // The logs are not fetched: they may be long, and the control may be writing them.
    private CheckedGauge OfMachine(GaugeSettings gauge)
    {
        var machine = machines.First(m => m.Machine.Name == gauge.Machine);
        if (machine.Names is not { } names)
        {
            return new(gauge, [], 0, [], machine.Problem);
        }

        var ours = names.Where(n => FileNamePattern.Fits(gauge.Files, n)).Order(StringComparer.Ordinal).ToArray();
        return new(
            gauge,
            [.. ours.Take(MostLookedAt).Select(n => new CheckedFile(ShownName.Of(n), null, null))],
            Math.Max(0, ours.Length - MostLookedAt),
            [],
            null);
    }

    private CheckedGauge OfFolder(GaugeSettings gauge, string folder, CancellationToken cancellation)
    {
        try
        {
            var listing = new FinishedFiles(gauge with { Finished = new FinishedByRename() }, TimeProvider.System);
            var markers = new FinishedFiles(gauge, TimeProvider.System);
            var files = listing.Of(new(folder)).Where(f => markers.IsOurs(f.Name)).ToArray();
            return new(
                gauge,
                [.. files.Take(MostLookedAt).Select(f => Of(gauge, f, cancellation))],
                Math.Max(0, files.Length - MostLookedAt),
                listing.Left,
                Denied(gauge, folder));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return new(gauge, [], 0, [], CheckProblem.Of(
                CellCodes.GaugeAway,
                $"The folder {folder} of the gauge \"{gauge.Name}\" cannot be looked into: {e.Message.TrimEnd('.')}. Is it there, is the "
                    + $"share mounted, and may this user read it?"));
        }
    }

    // No attribute shows reliably whether files can be moved out: share permissions, quotas and read-only mounts matter too. So this
    // creates and removes an empty folder, which no gauge or cell mistakes for a measurement.
    internal static CheckProblem? Denied(GaugeSettings gauge, string folder)
    {
        var aside = Path.Combine(folder, ClaimFolder.Name);
        var tried = folder;
        try
        {
            TryOut(folder);
            tried = aside;
            using var pinned = PinnedFolder.Open(aside);
            if (pinned is not null)
            {
                TryOut(pinned.Path);
            }

            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return CheckProblem.Of(
                CellCodes.GaugeDenied,
                $"Files cannot be taken out of the folder of the gauge \"{gauge.Name}\": in {tried} nothing can be made and removed "
                    + $"again: {e.Message.TrimEnd('.')}. Give it to the user that the cell runs as.");
        }
    }

    private static void TryOut(string folder)
    {
        var made = Path.Combine(folder, $"{ClaimFolder.Name}-check-{Guid.NewGuid():N}");
        Directory.CreateDirectory(made);
        Directory.Delete(made);
    }

    private CheckedFile Of(GaugeSettings gauge, FileInfo file, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var name = ShownName.Of(file.Name);
        var found = file.Length > gauge.MostBytes
            ? RecognitionResult.Refused(
                RecognitionResult.TooLarge,
                FormattableString.Invariant($"It has {file.Length} bytes; \"{gauge.Name}\" takes at most {gauge.MostBytes}."))
            : FileReading.Whole(file) is { } bytes ? _recognizer.Recognize(gauge.Name, name, bytes)
            : RecognitionResult.Refused(
                CellCodes.FileLeft, "It changes, or cannot be opened: it would be taken as soon as it can be read.");
        return new(name, file.Length, found);
    }
}

/// <summary>The current state of a gauge's folder, or of the machine that its logs come from.</summary>
/// <param name="Gauge">The gauge.</param>
/// <param name="Files">The first files that match its pattern, and what the cell would do with each.</param>
/// <param name="More">How many more match.</param>
/// <param name="Left">Matching files that the cell would leave where they are.</param>
/// <param name="Problem">Why the source cannot be checked; null if nothing is wrong.</param>
public sealed record CheckedGauge(
    GaugeSettings Gauge, IReadOnlyList<CheckedFile> Files, int More, IReadOnlyList<LeftFile> Left, CheckProblem? Problem);

/// <summary>A file waiting at a gauge.</summary>
/// <param name="Name">Its name, made safe for display.</param>
/// <param name="Bytes">Its length; null for a log at a machine.</param>
/// <param name="Found">The job that would take it, or why none would; null for a log at a machine, which is not fetched.</param>
public sealed record CheckedFile(string Name, long? Bytes, RecognitionResult? Found);
