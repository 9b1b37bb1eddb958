using System.Security.Cryptography;
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
public sealed partial class JobEdits(CellSettings settings, CellStore store, UserBook users)
{
    /// <summary>Audit trail code for a job that was replaced.</summary>
    public const string Edited = "job-edited";

    /// <summary>Audit trail code for a job whose files could not be replaced.</summary>
    public const string EditFailed = "job-edit-failed";

    /// <summary>Checks an edited job, both as a job and as a job of this cell.</summary>
    /// <param name="job">The job in the cell, or one of <see cref="PreparedFor"/>.</param>
    /// <param name="draft">The edited job.</param>
    public DraftCheck Check(CellJobSettings job, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(job);
        var check = MatingDraftCheck.Of(draft, job.File);
        return check.Job is { } edited ? check with { Problems = [.. check.Problems, .. Contradictions(job, edited)] } : check;
    }

    /// <summary>SHA-256 of the job's current file; empty if there is none.</summary>
    /// <exception cref="InputException">It cannot be read.</exception>
    public static string Sha256Of(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return File.Exists(job.File) ? HashOf(InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes)) : "";
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

        var files = FilesOf(job, draft);
        var isInUse = IsInUse(job);
        if (!isInUse)
        {
            DemandInside(job, files);
        }

        DemandOwn(job, draft, files);
        var (before, after) = (VersionFiles(job), VersionFiles(job, draft, files));
        var hash = HashOf(files[^1].Bytes);

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
                    Keep(job, by, before, after);
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

    // The files that differ from the existing ones; the job's own file always, and last.
    private static List<(string Path, ReadOnlyMemory<byte> Bytes)> FilesOf(CellJobSettings job, MatingDraft draft)
    {
        var files = new List<(string Path, ReadOnlyMemory<byte> Bytes)>();
        if (draft.Program is { } program)
        {
            if (draft.Counterpart.Program != Path.GetFileName(draft.Counterpart.Program))
            {
                throw new JobEditException(
                    JobEditException.Wrong,
                    $"The imported program would be written to {draft.Counterpart.Program}, outside of the job's folder. Import it by "
                        + $"its own name.");
            }

            Add(draft.Counterpart.Program, program.Bytes);
        }

        Add(draft.TheoreticalFile, MatingDraftFiles.Theoretical(draft));
        files.Add((job.File, MatingDraftFiles.Job(draft)));
        return files;

        void Add(string name, ReadOnlyMemory<byte> bytes)
        {
            var path = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File) ?? "", name));
            if (!File.Exists(path) || !InputFile.Open(path, File.ReadAllBytes).AsSpan().SequenceEqual(bytes.Span))
            {
                files.Add((path, bytes));
            }
        }
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
                "$.counterpart.dialect",
                "other-dialect",
                edited.Counterpart.Dialect,
                $"a job for the dialect {edited.Counterpart.Dialect}; {machine.Name} has {machine.Dialect}");
        }

        if (StandingFrom(PlaceOf(job)) is { } from && from != edited.Compensation.From)
        {
            yield return new(
                "$.compensation.from",
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

    private static string HashOf(ReadOnlyMemory<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes.Span));
}
