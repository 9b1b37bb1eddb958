using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Replaces a cell's mating jobs with edited ones: all files of a job or none, with an audit entry before the first file
/// changes.</summary>
/// <remarks>The store keeps the content of every saved version, and of replaced files that were not saved here (<see cref="Versions"/>).
/// A new job is first saved as a prepared job (<see cref="Prepare"/>) and later put in use (<see cref="PutInUse"/>).</remarks>
/// <remarks>A running cell reads a job's files for each computation, so the next measurement uses them. An edit cannot change what the
/// cell read at startup: whose measurements the job takes, machine and slot, and the dialect.</remarks>
/// <param name="settings">The cell's configuration.</param>
/// <param name="store">The store.</param>
/// <param name="users">The users.</param>
public sealed class JobEdits(CellSettings settings, CellStore store, UserBook users)
{
    private readonly PreparedJobs _prepared = new(settings);
    private readonly JobVersions _versions = new(settings, store);

    /// <summary>Audit trail code for a job that was replaced.</summary>
    public const string Edited = "job-edited";

    /// <summary>Audit trail code for a job whose files could not be replaced.</summary>
    public const string EditFailed = "job-edit-failed";

    /// <summary>Audit trail code for a job that was saved but is not in use.</summary>
    public const string Prepared = "job-prepared";

    /// <summary>Audit trail code for a job that was not saved here and was stored when another replaced it.</summary>
    public const string Found = "job-found";

    /// <summary>True for a job that the configuration names, which its gauges use.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    public bool IsInUse(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return _prepared.IsInUse(job);
    }

    /// <summary>The cell's job that a prepared job may replace; for a job in use, the job itself.</summary>
    /// <param name="job">A job of the configuration, or one of <see cref="PreparedFor"/>.</param>
    /// <exception cref="ArgumentException">It is neither.</exception>
    public CellJobSettings PlaceOf(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return _prepared.PlaceOf(job);
    }

    /// <summary>The prepared jobs for the place of a job, by name. Each has the machine, slot and gauges of that place.</summary>
    /// <param name="job">The job in the cell.</param>
    /// <exception cref="InputException">Their folder cannot be read.</exception>
    public IReadOnlyList<CellJobSettings> PreparedFor(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return _prepared.For(job);
    }

    /// <summary>Checks an edited job, both as a job and as a job of this cell.</summary>
    /// <param name="job">The job in the cell, or one of <see cref="PreparedFor"/>.</param>
    /// <param name="draft">The edited job.</param>
    public DraftCheck Check(CellJobSettings job, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(job);
        var check = MatingDraftCheck.Run(draft, job.File);
        return check.Job is { } edited ? check with { Problems = [.. check.Problems, .. Contradictions(job, edited)] } : check;
    }

    /// <summary>SHA-256 of the job's current file; empty if there is none.</summary>
    /// <exception cref="InputException">It cannot be read.</exception>
    public static string Sha256Of(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return File.Exists(job.File) ? ContentHash.Sha256(InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes)) : "";
    }

    /// <summary>Replaces a job's files, and stores the new and the previous ones.</summary>
    /// <param name="job">The job in the cell, or one of <see cref="PreparedFor"/>.</param>
    /// <param name="draft">The edited job.</param>
    /// <param name="baseSha256">SHA-256 of the job's file that the edit is based on (<see cref="Sha256Of"/>).</param>
    /// <param name="by">The user, with the password entered for this act if the job is in use.</param>
    /// <returns>SHA-256 of the job's new file.</returns>
    /// <exception cref="PeopleException">That user may not edit jobs, or has not signed.</exception>
    /// <exception cref="JobEditException">The edited job must not replace the existing one.</exception>
    /// <exception cref="OutputException">The files cannot be written; the existing ones stay.</exception>
    /// <exception cref="InputException">The existing files cannot be read.</exception>
    /// <exception cref="StoreException">The store is unavailable; nothing was replaced.</exception>
    public string Save(CellJobSettings job, MatingDraft draft, string baseSha256, SignedIn by)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(by);
        if (Check(job, draft).Problems is [var wrong, ..])
        {
            throw new JobEditException(JobEditException.Wrong, wrong.Message);
        }

        if (Sha256Of(job) != baseSha256)
        {
            throw new JobEditException(
                JobEditException.ChangedMeanwhile,
                $"{job.File} was changed since it was opened. Note what you changed, discard your changes, and make them in the job as "
                    + $"it is now.");
        }

        var files = EditedFiles.ToWrite(job, draft);
        var isInUse = IsInUse(job);
        if (!isInUse)
        {
            PreparedJobs.DemandInside(job, files);
        }

        DemandOwn(job, draft, files);
        var (before, after) = (JobVersions.FilesOf(job), JobVersions.FilesOf(job, draft, files));
        var hash = ContentHash.Sha256(files[^1].Bytes.Span);

        // A signature is valid for one act, so use it only after all other checks have passed.
        users.Demand(by, isInUse ? Act.EditJobs : Act.PrepareJobs);
        var isToldOf = false;
        try
        {
            // Write the audit entry first: no job changes without it.
            OutputFile.WriteAll(
                files,
                [],
                () =>
                {
                    _versions.Keep(job, by, before, after);
                    return isToldOf = true;
                },
                CancellationToken.None);
        }
        catch (OutputException e) when (isToldOf)
        {
            store.Audit(by.Name, EditFailed, e.Message, job.Name);
            throw;
        }

        return hash;
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
        var prepared = PreparedJobs.At(place, name);
        PreparedJobs.DemandFree(place, name);
        draft = EditedFiles.Moved(draft, job, prepared);
        if (Check(prepared, draft).Problems is [var wrong, ..])
        {
            throw new JobEditException(JobEditException.Wrong, wrong.Message);
        }

        var files = EditedFiles.ToWrite(prepared, draft);
        PreparedJobs.DemandInside(prepared, files);
        Write(prepared, files, () => _versions.Keep(prepared, by, [], JobVersions.FilesOf(prepared, draft, files)), by);
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
        if (!EditedFiles.IsSaved(job, draft))
        {
            throw new JobEditException(JobEditException.ChangedMeanwhile, $"{job.File} was changed since it was opened. Open it again.");
        }

        return Save(place, WithOwnFiles(place, EditedFiles.Moved(draft, job, place) with { IsBegunAnew = true }), baseSha256, by);
    }

    /// <summary>All versions of a job, the latest first.</summary>
    /// <param name="job">The job in the cell, or one of <see cref="PreparedFor"/>.</param>
    /// <exception cref="StoreException">The store is unavailable.</exception>
    public IReadOnlyList<JobVersion> Versions(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return _versions.Of(job);
    }

    /// <summary>Opens a version as a draft. Opening changes nothing; saving the draft restores the version.</summary>
    /// <param name="job">The job in the cell.</param>
    /// <param name="version">One of its <see cref="Versions"/>.</param>
    /// <exception cref="StoreException">The store is unavailable, or a content is damaged.</exception>
    /// <exception cref="JobEditException">A file of the job was not stored with it.</exception>
    /// <exception cref="InputException">The job is no longer usable. Its theoretical points are no longer usable.</exception>
    /// <exception cref="DraftException">The theoretical points have columns that a draft cannot represent and would
    /// lose.</exception>
    public MatingDraft Open(CellJobSettings job, JobVersion version)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(version);
        return _versions.Open(job, version);
    }

    /// <summary>The draft of a new job with its own files; a number is appended to a name that is taken.</summary>
    /// <param name="job">The job in the cell, whose folder is used.</param>
    /// <param name="draft">The new job.</param>
    public static MatingDraft WithOwnFiles(CellJobSettings job, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(draft);
        return EditedFiles.WithOwnFiles(job, draft);
    }

    private void DemandOwn(CellJobSettings job, MatingDraft draft, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files)
    {
        if (draft.IsBegunAnew && files.SkipLast(1).Select(f => f.Path).FirstOrDefault(File.Exists) is { } taken)
        {
            throw new JobEditException(
                JobEditException.Shared, $"{taken} is there already and belongs to the job before. Give the new job files of its own.");
        }

        foreach (var other in settings.Jobs.Where(j => !CellPaths.AreSame(j.File, job.File)))
        {
            IReadOnlyList<string> named;
            try
            {
                named = NamedJob.Read(other.File).Files;
            }
            catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
            {
                // Its own measurements report that it is unusable, so nothing in it can be damaged.
                continue;
            }

            if (files.Select(f => f.Path).FirstOrDefault(f => named.Any(n => CellPaths.AreSame(n, f))) is { } shared)
            {
                throw new JobEditException(
                    JobEditException.Shared,
                    $"{shared} belongs to the job {other.Name} as well, which would change with it. Give each of the two its own file.");
            }
        }
    }

    private IEnumerable<DraftProblem> Contradictions(CellJobSettings job, MatingJob edited)
    {
        var machine = settings.Machines.First(m => m.Name == job.Machine);
        var dialect = Nc.NcDialects.IsFile(edited.Counterpart.Dialect)
            ? Path.GetFullPath(edited.PathOf(edited.Counterpart.Dialect))
            : edited.Counterpart.Dialect;
        if (!CellPaths.AreSame(machine.Dialect, dialect))
        {
            yield return new(
                DraftPaths.Dialect,
                "other-dialect",
                edited.Counterpart.Dialect,
                $"a job for the dialect {edited.Counterpart.Dialect}; {machine.Name} has {machine.Dialect}");
        }

        if (StandingFrom(PlaceOf(job)) is { } from && from != edited.Compensation.From)
        {
            yield return new(
                DraftPaths.From,
                "from-fixed",
                "",
                "the cell decides by it when it starts whose measurements these are; change it in the job's file and start the cell again");
        }
    }

    private static CompensationSource? StandingFrom(CellJobSettings job)
    {
        try
        {
            return InputFile.Job(job.File).Compensation.From;
        }
        catch (InputException)
        {
            // A job that cannot be read has decided nothing.
            return null;
        }
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
                SharedFile.RenameFolder(beside, folder);
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
}

/// <summary>Thrown if an edited job must not be saved, either in place of the existing one or as a prepared job.</summary>
/// <param name="code">The reason: one of the constants here.</param>
/// <param name="message">A sentence for the user: what was found and what to do.</param>
public sealed class JobEditException(string code, string message) : Exception(message)
{
    /// <summary>The job has a problem.</summary>
    public const string Wrong = "wrong";

    /// <summary>Another user changed the job since it was opened.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>Another job of the cell uses a file that would be replaced.</summary>
    public const string Shared = "shared";

    /// <summary>A saved job with this name already exists.</summary>
    public const string NameTaken = "name-taken";

    /// <summary>The new job's name is not a valid folder name.</summary>
    public const string NotAName = "not-a-name";

    /// <summary>The folder for saved jobs is a file or a link.</summary>
    public const string NoFolder = "no-folder";

    /// <summary>A stored version is incomplete: one of its files was in another folder.</summary>
    public const string Incomplete = "incomplete";

    /// <summary>The reason.</summary>
    public string Code => code;
}
