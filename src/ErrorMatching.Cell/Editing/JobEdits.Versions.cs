using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <content>The versions of a job: stored with each save, and opened again as drafts.</content>
public sealed partial class JobEdits
{
    /// <summary>Audit trail code for a job that was not saved here and was stored when another replaced it.</summary>
    public const string Found = "job-found";

    /// <summary>All versions of a job, the latest first.</summary>
    /// <param name="job">The job in the cell, or one of <see cref="PreparedFor"/>.</param>
    /// <exception cref="StoreException">The store is unavailable.</exception>
    public IReadOnlyList<JobVersion> Versions(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var (place, word) = (PlaceOf(job), IsInUse(job) ? Edited : Prepared);
        var names = settings.Jobs.Where(j => CellPaths.AreSame(j.File, place.File))
            .Select(j => word == Edited ? j.Name : At(j, NameOf(job)).Name).Append(job.Name).ToHashSet();
        return
        [
            .. store
                .Read(AuditRow.Select + " WHERE what = @word OR what = @Found ORDER BY seq DESC", AuditRow.Read, new { word, Found })
                .Where(e => e.Subject is { } subject && names.Contains(subject))
                .Select(Version)
                .OfType<JobVersion>()
                .Where(v => v.Files.All(f => IsKept(f.Sha256)))
                .Select(v => v with { Name = NameIn(v) }),
        ];
    }

    /// <summary>Opens a version as a draft. Opening changes nothing; saving the draft restores the version.</summary>
    /// <param name="job">The job in the cell.</param>
    /// <param name="version">One of its <see cref="Versions"/>.</param>
    /// <exception cref="StoreException">The store is unavailable, or a content is damaged.</exception>
    /// <exception cref="JobEditException">A file of the job was not stored with it.</exception>
    /// <exception cref="InputException">The job is no longer usable. Its theoretical points are no longer usable.</exception>
    /// <exception cref="DraftException">The job contains something that a draft cannot represent and would lose.</exception>
    public MatingDraft Open(CellJobSettings job, JobVersion version)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(version);
        var bytes = store.Content(version.Sha256);
        var parsed = MatingJob.Parse(bytes, job.File);
        var draft = MatingDraftFiles.Read(bytes, job.File, Content(parsed.Part.Theoretical));
        return draft with { Program = DraftProgram.Of(Content(parsed.Counterpart.Program)) };

        byte[] Content(string name) => version.Files.FirstOrDefault(f => f.Name == name) is { Sha256: { } sha256 }
            ? store.Content(sha256)
            : throw new JobEditException(
                JobEditException.Incomplete, $"{name} of {job.File} was not kept with this version. Bring it back by hand.");
    }

    /// <summary>The draft of a new job with its own files; a number is appended to a name that is taken.</summary>
    /// <param name="job">The job in the cell, whose folder is used.</param>
    /// <param name="draft">The new job.</param>
    public static MatingDraft WithOwnFiles(CellJobSettings job, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(draft);
        return draft with
        {
            TheoreticalFile = FreeName(job, draft.TheoreticalFile, MatingDraftFiles.Theoretical(draft)),
            Counterpart = draft.Program is { } program
                ? draft.Counterpart with { Program = FreeName(job, draft.Counterpart.Program, program.Bytes) }
                : draft.Counterpart,
        };
    }

    private static string FreeName(CellJobSettings job, string name, ReadOnlyMemory<byte> bytes)
    {
        var free = name;
        for (var i = 2; IsTaken(job, free, bytes); i++)
        {
            var stem = Path.Combine(Path.GetDirectoryName(name) ?? "", Path.GetFileNameWithoutExtension(name));
            free = string.Create(CultureInfo.InvariantCulture, $"{stem}-{i}{Path.GetExtension(name)}");
        }

        return free;
    }

    // A file with the same bytes does not conflict; nothing is written.
    private static bool IsTaken(CellJobSettings job, string name, ReadOnlyMemory<byte> bytes) =>
        PathOf(job, name) is var path && File.Exists(path) && !InputFile.Open(path, File.ReadAllBytes).AsSpan().SequenceEqual(bytes.Span);

    private static string PathOf(CellJobSettings job, string name) =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File) ?? "", name));

    // For jobs saved before versions were stored, the audit trail has only the hashes.
    private bool IsKept(string sha256) => store.Read("SELECT 1 FROM content WHERE sha256 = @sha256", _ => true, new { sha256 }).Count > 0;

    private static JobVersion? Version(AuditEntry entry)
    {
        var list = Recorded.JobInPlace.Read(entry.Basis) is [var written, ..] ? written : entry.Basis;
        var found = FileAndHash().Matches(list);
        (string Name, string Sha256)[] files = [.. found.Select(m => (m.Groups["name"].Value, m.Groups["hash"].Value))];
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

    // The current files; empty if they are not a job, which could not be opened again.
    private static List<(string Name, byte[] Bytes)> VersionFiles(CellJobSettings job)
    {
        try
        {
            var bytes = InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes).ToArray();
            var parsed = MatingJob.Parse(bytes, job.File);
            return
            [
                .. new[] { parsed.Part.Theoretical, parsed.Counterpart.Program }.Where(n => File.Exists(PathOf(job, n)))
                    .Select(n => (n, InputFile.Open(PathOf(job, n), File.ReadAllBytes))),
                (Path.GetFileName(job.File), bytes),
            ];
        }
        catch (InputException)
        {
            return [];
        }
    }

    // The files after saving: those to be written, and the others as they are.
    private static List<(string Name, byte[] Bytes)> VersionFiles(
        CellJobSettings job, MatingDraft draft, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files)
    {
        var version = new List<(string Name, byte[] Bytes)>();
        foreach (var name in new[] { draft.TheoreticalFile, draft.Counterpart.Program })
        {
            var path = PathOf(job, name);
            if (files.FirstOrDefault(f => f.Path == path) is { Path: not null } written)
            {
                version.Add((name, written.Bytes.ToArray()));
            }
            else if (File.Exists(path))
            {
                version.Add((name, InputFile.Open(path, File.ReadAllBytes)));
            }
        }

        version.Add((Path.GetFileName(job.File), files[^1].Bytes.ToArray()));
        return version;
    }

    private static string Told(IEnumerable<(string Name, byte[] Bytes)> files) =>
        string.Join(", ", files.Select(f => $"{f.Name} {HashOf(f.Bytes)}"));

    // Stores before and after in one transaction with their audit entry; what was saved here is already stored.
    private void Keep(
        CellJobSettings job, SignedIn by, List<(string Name, byte[] Bytes)> before, List<(string Name, byte[] Bytes)> after)
    {
        var found = Told(before);
        var isKnown = before.Count == 0 || Versions(job).Any(v => v.Files.SequenceEqual(before.Select(f => (f.Name, HashOf(f.Bytes)))));
        store.Write(t =>
        {
            foreach (var (_, bytes) in before.Concat(after))
            {
                CellStore.Keep(t, HashOf(bytes), bytes);
            }

            if (!isKnown)
            {
                t.Audit(by.Name, Found, job.Name, found);
            }

            var written = Told(after);
            var basis = before.Count > 0 ? Recorded.JobInPlace.With(written, HashOf(before[^1].Bytes)) : written;
            t.Audit(by.Name, IsInUse(job) ? Edited : Prepared, job.Name, basis);
            return true;
        });
    }

    [GeneratedRegex(
        "(^|, )(?<name>.+?) (?<hash>[0-9a-f]{64})", RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, Timeout.Infinite)]
    private static partial Regex FileAndHash();
}
