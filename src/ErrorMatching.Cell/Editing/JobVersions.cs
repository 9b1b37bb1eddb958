using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The versions of a job: stored with each save, and opened again as drafts.</summary>
/// <param name="settings">The cell's configuration.</param>
/// <param name="store">The store.</param>
internal sealed class JobVersions(CellSettings settings, CellStore store)
{
    private readonly PreparedJobs _prepared = new(settings);

    /// <inheritdoc cref="JobEdits.Versions"/>
    public IReadOnlyList<JobVersion> Of(CellJobSettings job)
    {
        var (place, word) = (_prepared.PlaceOf(job), WordFor(job));
        var names = settings.Jobs.Where(j => CellPaths.AreSame(j.File, place.File))
            .Select(j => word == JobEdits.Edited ? j.Name : PreparedJobs.At(j, PreparedJobs.NameOf(job)).Name).Append(job.Name).ToHashSet();
        return
        [
            .. store
                .Read(
                    AuditRow.Select + " WHERE what = @word OR what = @Found ORDER BY seq DESC",
                    AuditRow.Read,
                    [("word", word), ("Found", JobEdits.Found)])
                .Where(e => e.Subject is { Words: { } subject } && names.Contains(subject))
                .Select(Version)
                .OfType<JobVersion>()
                .Where(v => v.Files.All(f => IsKept(f.Sha256)))
                .Select(v => v with { Name = NameIn(v) }),
        ];
    }

    /// <inheritdoc cref="JobEdits.Open"/>
    public MatingDraft Open(CellJobSettings job, JobVersion version)
    {
        var bytes = store.Content(version.Sha256);
        var parsed = MatingJob.Parse(bytes, job.File);
        var draft = MatingDraftFiles.Read(bytes, job.File, Content(parsed.Part.Theoretical));
        return draft with { Program = DraftProgram.Of(Content(parsed.Counterpart.Program)) };

        byte[] Content(string name) => version.Files.FirstOrDefault(f => f.Name == name) is { Sha256: { } sha256 }
            ? store.Content(sha256)
            : throw new JobEditException(
                JobEditException.Incomplete, $"{name} of {job.File} was not kept with this version. Bring it back by hand.");
    }

    // For jobs saved before versions were stored, the audit trail has only the hashes.
    private bool IsKept(string sha256) => store.Keeps(sha256);

    private string WordFor(CellJobSettings job) => _prepared.IsInUse(job) ? JobEdits.Edited : JobEdits.Prepared;

    private static JobVersion? Version(AuditEntry entry)
    {
        var written = entry.Basis.Is(Recorded.JobInPlace) ? entry.Basis.Values[0] : entry.Basis;
        IReadOnlyList<(string Name, string Sha256)> files = written.Is(Recorded.JobFiles)
            ? [
                .. written.Values[0].Parts.Where(f => f.Is(Recorded.JobFile))
                    .Select(f => (f.Values[0].Sentence, f.Values[1].Sentence))]
            : EnglishRecord.JobFilesOf(entry.Basis);
        return files is [.., var job] ? new(entry.Seq, entry.At, entry.Who, "", job.Sha256, files) : null;
    }

    // The name as written in the file; a version that is no longer usable still has its name.
    private string NameIn(JobVersion version)
    {
        try
        {
            var root = JsonInput.Read(store.Content(version.Sha256), version.Files[^1].Name);
            return root.Kind == JsonItemKind.Object && root.Find("name") is { Kind: JsonItemKind.Text } name ? name.Text : "";
        }
        catch (InputException)
        {
            return "";
        }
    }

    /// <summary>The current files of a job; empty if they are not a job, which could not be opened again.</summary>
    public static List<(string Name, byte[] Bytes)> FilesOf(CellJobSettings job)
    {
        try
        {
            var bytes = InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes).ToArray();
            var parsed = MatingJob.Parse(bytes, job.File);
            return
            [
                .. new[] { parsed.Part.Theoretical, parsed.Counterpart.Program }.Where(n => File.Exists(EditedFiles.PathOf(job, n)))
                    .Select(n => (n, InputFile.Open(EditedFiles.PathOf(job, n), SharedFile.ReadAllBytes))),
                (Path.GetFileName(job.File), bytes),
            ];
        }
        catch (InputException)
        {
            return [];
        }
    }

    /// <summary>The files of a job after saving: those to be written, and the others as they are.</summary>
    public static List<(string Name, byte[] Bytes)> FilesOf(
        CellJobSettings job, MatingDraft draft, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files)
    {
        var version = new List<(string Name, byte[] Bytes)>();
        foreach (var name in new[] { draft[DraftPaths.Theoretical], draft[DraftPaths.Program] })
        {
            var path = EditedFiles.PathOf(job, name);
            if (files.FirstOrDefault(f => f.Path == path) is { Path: not null } written)
            {
                version.Add((name, written.Bytes.ToArray()));
            }
            else if (File.Exists(path))
            {
                version.Add((name, InputFile.Open(path, SharedFile.ReadAllBytes)));
            }
        }

        version.Add((Path.GetFileName(job.File), files[^1].Bytes.ToArray()));
        return version;
    }

    private static Statement Stated(IEnumerable<(string Name, byte[] Bytes)> files) =>
        Recorded.JobFiles.With(files.Select(f => Recorded.JobFile.With(f.Name, ContentHash.Sha256(f.Bytes))));

    /// <summary>Stores the files before and after a save in one transaction with the audit entry. What was saved here is already
    /// stored.</summary>
    public void Keep(
        CellJobSettings job, SignedIn by, List<(string Name, byte[] Bytes)> before, List<(string Name, byte[] Bytes)> after)
    {
        var found = Stated(before);
        var isKnown = before.Count == 0
            || Of(job).Any(v => v.Files.SequenceEqual(before.Select(f => (f.Name, ContentHash.Sha256(f.Bytes)))));
        var kept = StoredContent.Pack([.. before.Concat(after).Select(f => (ReadOnlyMemory<byte>)f.Bytes)]);
        store.Write(t =>
        {
            foreach (var (sha256, content) in kept)
            {
                StoredContent.Keep(t, sha256, content);
            }

            if (!isKnown)
            {
                t.Audit(by.Name, JobEdits.Found, job.Name, found);
            }

            var written = Stated(after);
            var basis = before.Count > 0 ? Recorded.JobInPlace.With(written, ContentHash.Sha256(before[^1].Bytes)) : written;
            t.Audit(by.Name, WordFor(job), job.Name, basis);
            return true;
        });
    }
}

/// <summary>A saved version of a job, stored by content.</summary>
/// <param name="Entry">Number of its entry in the audit trail.</param>
/// <param name="At">When it was saved, or found if it was not saved here.</param>
/// <param name="By">Who saved or replaced it.</param>
/// <param name="Name">The job's name then: the workpiece; empty if the file has none.</param>
/// <param name="Sha256">SHA-256 of the job's file.</param>
/// <param name="Files">SHA-256 of all its own files by name, the job's file last.</param>
public sealed record JobVersion(
    long Entry, DateTimeOffset At, string By, string Name, string Sha256, IReadOnlyList<(string Name, string Sha256)> Files);
