using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Cell;

/// <content>Jobs that are prepared beside the one that runs: each in a folder of its own that no configuration names, so no measurement
/// is computed by it before somebody puts it in use.</content>
public sealed partial class JobEdits
{
    /// <summary>The word of the audit trail for a job that was saved and is not in use.</summary>
    public const string Prepared = "job-prepared";

    private const string FolderEnding = ".saved";
    private const string FileName = "job.json";

    /// <summary>True for a job that the configuration names: what its gauges run.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    public bool IsInUse(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return settings.Jobs.Any(j => CellPaths.AreSame(j.File, job.File));
    }

    /// <summary>The job in the cell whose place a prepared job may take; a job that is in use has its own.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    /// <exception cref="ArgumentException">It is neither.</exception>
    public CellJobSettings PlaceOf(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return IsInUse(job) ? job
            : settings.Jobs.FirstOrDefault(j => CellPaths.AreSame(At(j, NameOf(job)).File, job.File))
            ?? throw new ArgumentException($"{job.File} is no job of this cell.", nameof(job));
    }

    /// <summary>The jobs that are prepared for the place of one, by their names. Each has the machine, slot and gauges of that place.
    /// </summary>
    /// <param name="job">The job in the cell.</param>
    /// <exception cref="InputException">Their folder cannot be read.</exception>
    public IReadOnlyList<CellJobSettings> PreparedFor(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var folder = FolderOf(job);
        return InputFile.Open(folder, IReadOnlyList<CellJobSettings> (_) =>
        [
            .. Entries(folder).Where(e => SavedJobName.Defect(Path.GetFileName(e)) is null).Select(e => At(job, Path.GetFileName(e)))
                .Where(j => IsPlain(j) && !IsInUse(j)).OrderBy(j => j.Name, StringComparer.Ordinal),
        ]);
    }

    /// <summary>Saves a new job beside the one that runs, in a folder that has the job's name. Nothing that is there changes.</summary>
    /// <param name="job">The job where it was begun: in use or prepared.</param>
    /// <param name="draft">The new job.</param>
    /// <param name="by">Who does it.</param>
    /// <returns>The prepared job: opened, changed and saved as any other, and none that runs.</returns>
    /// <exception cref="PeopleException">That user may not prepare jobs.</exception>
    /// <exception cref="JobEditException">Something in the job is wrong; its name is taken, or cannot be one of a folder.</exception>
    /// <exception cref="InputException">Its program cannot be read.</exception>
    /// <exception cref="OutputException">It cannot be written; nothing of it is left.</exception>
    /// <exception cref="StoreException">The store is away; nothing was written.</exception>
    public CellJobSettings Prepare(CellJobSettings job, MatingDraft draft, SignedIn by)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(by);
        var (place, name) = (PlaceOf(job), draft.Name.Trim());
        if (SavedJobName.Defect(name) is { } defect)
        {
            throw new JobEditException(JobEditException.NotAName, $"A saved job cannot be called \"{draft.Name}\": {defect}.");
        }

        users.Demand(by, Act.PrepareJobs);
        var prepared = At(place, name);
        DemandFree(place, name);
        draft = Moved(draft, job, prepared);
        if (Check(prepared, draft).Problems is [var wrong, ..])
        {
            throw new JobEditException(JobEditException.Wrong, wrong.Message);
        }

        var files = FilesOf(prepared, draft);
        DemandInside(prepared, files);
        Write(prepared, files, () => Keep(prepared, by, [], VersionFiles(prepared, draft, files)), by);
        return prepared;
    }

    /// <summary>Puts a prepared job in the place of the one that runs, with files of its own there. The prepared one stays.</summary>
    /// <param name="job">One of <see cref="PreparedFor"/>.</param>
    /// <param name="draft">The job as it was seen: it is refused where another one was saved meanwhile.</param>
    /// <param name="baseSha256"><see cref="Sha256Of"/> of the job whose place it takes (<see cref="PlaceOf"/>).</param>
    /// <param name="by">Who does it, with the password given for this act.</param>
    /// <inheritdoc cref="Save" path="/returns|/exception"/>
    public string PutInUse(CellJobSettings job, MatingDraft draft, string baseSha256, SignedIn by)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var place = PlaceOf(job);
        if (!IsSaved(job, draft))
        {
            throw new JobEditException(JobEditException.ChangedMeanwhile, $"{job.File} was changed since it was opened. Open it again.");
        }

        return Save(place, WithOwnFiles(place, Moved(draft, job, place) with { IsBegunAnew = true }), baseSha256, by);
    }

    // As both would be written: numbers are typed in several ways.
    private static bool IsSaved(CellJobSettings job, MatingDraft draft)
    {
        try
        {
            var saved = MatingDraftFiles.Open(job.File);
            return MatingDraftFiles.Job(saved).AsSpan().SequenceEqual(MatingDraftFiles.Job(draft))
                && MatingDraftFiles.Theoretical(saved).AsSpan().SequenceEqual(MatingDraftFiles.Theoretical(draft));
        }
        catch (Exception e) when (e is JobException or MeasurementException or DraftException)
        {
            return false;
        }
    }

    private static string FolderOf(CellJobSettings place) => place.File + FolderEnding;

    private static string NameOf(CellJobSettings prepared) => Path.GetFileName(Path.GetDirectoryName(prepared.File)) ?? "";

    private static CellJobSettings At(CellJobSettings place, string name) =>
        place with { Name = $"{place.Name}/{name}", File = Path.Combine(FolderOf(place), name, FileName) };

    // A link leads elsewhere, perhaps to a job that runs: nothing is behind one here.
    private static string[] Entries(string folder) =>
        new DirectoryInfo(folder) is { Exists: true, LinkTarget: null } ? Directory.GetFileSystemEntries(folder) : [];

    private static bool IsPlain(CellJobSettings prepared) =>
        new DirectoryInfo(Path.GetDirectoryName(prepared.File)!) is { Exists: true, LinkTarget: null }
        && new FileInfo(prepared.File) is { Exists: true } file && PlainFile.Defect(file) is null;

    private static void DemandFree(CellJobSettings place, string name)
    {
        var folder = FolderOf(place);
        if (File.Exists(folder) || new DirectoryInfo(folder).LinkTarget is not null)
        {
            throw new JobEditException(
                JobEditException.NoFolder, $"{folder}, where saved jobs are kept, is a file or a link. Remove it, and save again.");
        }

        // On some disks small and large letters are one name.
        var entries = InputFile.Open(folder, _ => Entries(folder));
        if (entries.Any(e => string.Equals(Path.GetFileName(e), name, StringComparison.OrdinalIgnoreCase)))
        {
            throw new JobEditException(
                JobEditException.NameTaken, $"There is something called {name} in {folder} already. Give the new job another name.");
        }
    }

    // Its files lie in its folder, and nowhere that belongs to a job that runs.
    private static void DemandInside(CellJobSettings prepared, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files)
    {
        var folder = Path.GetDirectoryName(prepared.File)!;
        if (files.Select(f => f.Path).FirstOrDefault(f => !CellPaths.AreSame(Path.GetDirectoryName(f)!, folder)) is { } outside)
        {
            throw new JobEditException(
                JobEditException.Shared, $"{outside} is not in {folder}, the folder of the saved job. Give it a file there.");
        }

        if (!IsInFolders(prepared))
        {
            throw new JobEditException(JobEditException.NoFolder, $"{folder} is a link. Remove it, and save the job under another name.");
        }
    }

    private static bool IsInFolders(CellJobSettings prepared)
    {
        var folder = new DirectoryInfo(Path.GetDirectoryName(prepared.File)!);
        return folder.LinkTarget is null && folder.Parent!.LinkTarget is null;
    }

    // The folder takes its name once all of it is there and the trail tells of it; one that has the name meanwhile stays.
    private void Write(
        CellJobSettings prepared, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files, Action keep, SignedIn by)
    {
        var folder = Path.GetDirectoryName(prepared.File)!;
        var beside = Path.Combine(Path.GetDirectoryName(folder)!, $".{Path.GetRandomFileName()}.tmp");
        try
        {
            OutputFile.WriteAll(
                [.. files.Select(f => (Path.Combine(beside, Path.GetFileName(f.Path)), f.Bytes))], [], CancellationToken.None);
            keep();
            try
            {
                Directory.Move(beside, folder);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                var failure = new OutputException(
                    OutputException.Unwritable, folder, $"{folder} cannot be written: {e.Message.TrimEnd('.')}.", e);
                store.Audit(by.Name, EditFailed, failure.Message, prepared.Name);
                throw failure;
            }
        }
        finally
        {
            Remove(beside);
        }
    }

    private static void Remove(string folder)
    {
        try
        {
            if (Directory.Exists(folder))
            {
                Directory.Delete(folder, recursive: true);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The failure that led here is the one to report; what is left begins with a dot and is no job.
        }
    }

    // The draft of one job as that of another: its program with it, its own files by their plain names, and what belongs to neither by the
    // way from there.
    private static MatingDraft Moved(MatingDraft draft, CellJobSettings from, CellJobSettings to)
    {
        var c = draft.Counterpart;
        return draft with
        {
            TheoreticalFile = Path.GetFileName(draft.TheoreticalFile.Trim()),
            MeasuredFile = Way(draft.MeasuredFile),
            Program = draft.Program ?? DraftProgram.Of(ProgramAt(PathOf(from, c.Program.Trim()))),
            Counterpart = c with
            {
                Program = Path.GetFileName(c.Program.Trim()),
                Dialect = NcDialects.IsFile(c.Dialect.Trim()) ? Way(c.Dialect) : c.Dialect,
                Measured = Way(c.Measured),
            },
        };

        string Way(string name) => string.IsNullOrWhiteSpace(name) || Path.IsPathRooted(name.Trim()) ? name
            : Path.GetRelativePath(Path.GetDirectoryName(to.File)!, PathOf(from, name.Trim())).Replace('\\', '/');
    }

    private static ReadOnlyMemory<byte> ProgramAt(string path)
    {
        try
        {
            return InputFile.Program(path);
        }
        catch (NcException e)
        {
            throw new JobEditException(JobEditException.Wrong, e.Message);
        }
    }
}
