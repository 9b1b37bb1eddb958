using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <content>Prepared jobs: each has its own folder that no configuration names, so no measurement uses it before it is put in
/// use.</content>
public sealed partial class JobEdits
{
    /// <summary>Audit trail code for a job that was saved but is not in use.</summary>
    public const string Prepared = "job-prepared";

    private const string FolderEnding = ".saved";
    private const string FileName = "job.json";

    /// <summary>True for a job that the configuration names, which its gauges use.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    public bool IsInUse(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return settings.Jobs.Any(j => CellPaths.AreSame(j.File, job.File));
    }

    /// <summary>The cell's job that a prepared job may replace; for a job in use, the job itself.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    /// <exception cref="ArgumentException">It is neither.</exception>
    public CellJobSettings PlaceOf(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return IsInUse(job) ? job
            : settings.Jobs.FirstOrDefault(j => CellPaths.AreSame(At(j, NameOf(job)).File, job.File))
            ?? throw new ArgumentException($"{job.File} is no job of this cell.", nameof(job));
    }

    /// <summary>The prepared jobs for the place of a job, by name. Each has the machine, slot and gauges of that place.</summary>
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

    /// <summary>Saves a new job as a prepared job, in a folder with the job's name. No existing file changes.</summary>
    /// <param name="job">The job, in use or prepared, in whose place the new one was started.</param>
    /// <param name="draft">The new job.</param>
    /// <param name="by">The user.</param>
    /// <returns>The prepared job. It can be opened, changed and saved like any other, but is not in use.</returns>
    /// <exception cref="PeopleException">That user may not prepare jobs.</exception>
    /// <exception cref="JobEditException">The job has a problem, or its name is taken or not a valid folder name.</exception>
    /// <exception cref="InputException">Its program cannot be read.</exception>
    /// <exception cref="OutputException">It cannot be written; nothing is left behind.</exception>
    /// <exception cref="StoreException">The store is unavailable; nothing was written.</exception>
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

    /// <summary>Replaces the job in use with a prepared job, with its own files there. The prepared job stays.</summary>
    /// <param name="job">One of <see cref="PreparedFor"/>.</param>
    /// <param name="draft">The job as the user saw it; refused if another version was saved meanwhile.</param>
    /// <param name="baseSha256"><see cref="Sha256Of"/> of the job that it replaces (<see cref="PlaceOf"/>).</param>
    /// <param name="by">The user, with the password entered for this act.</param>
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

    // Compare both as they would be written, because numbers can be typed in several ways.
    private static bool IsSaved(CellJobSettings job, MatingDraft draft)
    {
        try
        {
            var saved = MatingDraftFiles.Open(job.File);
            return MatingDraftFiles.Job(saved).AsSpan().SequenceEqual(MatingDraftFiles.Job(draft))
                && MatingDraftFiles.Theoretical(saved).AsSpan().SequenceEqual(MatingDraftFiles.Theoretical(draft));
        }
        catch (Exception e) when (e is InputException or DraftException)
        {
            return false;
        }
    }

    private static string FolderOf(CellJobSettings place) => place.File + FolderEnding;

    private static string NameOf(CellJobSettings prepared) => Path.GetFileName(Path.GetDirectoryName(prepared.File)) ?? "";

    private static CellJobSettings At(CellJobSettings place, string name) =>
        place with { Name = $"{place.Name}/{name}", File = Path.Combine(FolderOf(place), name, FileName) };

    // A link may lead to a job in use, so its target is ignored.
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

        // Some file systems ignore case.
        var entries = InputFile.Open(folder, _ => Entries(folder));
        if (entries.Any(e => string.Equals(Path.GetFileName(e), name, StringComparison.OrdinalIgnoreCase)))
        {
            throw new JobEditException(
                JobEditException.NameTaken, $"There is something called {name} in {folder} already. Give the new job another name.");
        }
    }

    // Its files must be in its folder, and not in one that belongs to a job in use.
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

    // Rename the folder once it is complete and in the audit trail. An existing folder with that name stays.
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
            // Report the original failure. What is left has a name that begins with a dot and is not a job.
        }
    }

    // Converts a draft from one job's place to another's: the program is included, the job's own files keep their plain names, and other
    // files are referenced by a relative path.
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
        catch (InputException e) when (e.Code == NcInputCodes.ProgramTooLarge)
        {
            throw new JobEditException(JobEditException.Wrong, e.Message);
        }
    }
}
