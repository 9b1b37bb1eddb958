using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>The files of edited jobs: their names, their places, and what is to be written.</summary>
internal static class EditedFiles
{
    /// <summary>The absolute path of a file that a job names.</summary>
    public static string PathOf(CellJobSettings job, string name) =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File) ?? "", name));

    /// <summary>The files that differ from the existing ones; the job's own file always, and last.</summary>
    /// <exception cref="JobEditException">The program would be outside of the job's folder.</exception>
    public static List<(string Path, ReadOnlyMemory<byte> Bytes)> ToWrite(CellJobSettings job, MatingDraft draft)
    {
        var files = new List<(string Path, ReadOnlyMemory<byte> Bytes)>();
        if (draft.Program is { } program)
        {
            if (draft[DraftPaths.Program] != Path.GetFileName(draft[DraftPaths.Program]))
            {
                throw new JobEditException(
                    JobEditException.Wrong,
                    $"The imported program would be written to {draft[DraftPaths.Program]}, outside of the job's folder. Import it by "
                        + $"its own name.");
            }

            Add(draft[DraftPaths.Program], program.Bytes);
        }

        Add(draft[DraftPaths.Theoretical], MatingDraftFiles.Theoretical(draft));
        files.Add((job.File, MatingDraftFiles.Job(draft)));
        return files;

        void Add(string name, ReadOnlyMemory<byte> bytes)
        {
            var path = PathOf(job, name);
            if (!File.Exists(path) || !InputFile.Open(path, SharedFile.ReadAllBytes).AsSpan().SequenceEqual(bytes.Span))
            {
                files.Add((path, bytes));
            }
        }
    }

    /// <summary>True if a job's files are as a draft has them. Both are compared as they would be written, because numbers can be typed in
    /// several ways.</summary>
    public static bool IsSaved(CellJobSettings job, MatingDraft draft)
    {
        try
        {
            var saved = MatingDraftFiles.Open(job.File);
            return MatingDraftFiles.Job(saved).AsSpan().SequenceEqual(MatingDraftFiles.Job(draft))
                && MatingDraftFiles.Theoretical(saved).AsSpan().SequenceEqual(MatingDraftFiles.Theoretical(draft));
        }
        catch (Exception e) when (e is InputException { Code: not MeasurementError.FileUnreadable } or DraftException)
        {
            return false;
        }
    }

    /// <inheritdoc cref="JobEdits.WithOwnFiles"/>
    public static MatingDraft WithOwnFiles(CellJobSettings job, MatingDraft draft) =>
        draft.With(DraftPaths.Theoretical, FreeName(job, draft[DraftPaths.Theoretical], MatingDraftFiles.Theoretical(draft)))
            .With(
                DraftPaths.Program,
                draft.Program is { } program
                    ? FreeName(job, draft[DraftPaths.Program], program.Bytes)
                    : draft[DraftPaths.Program]);

    /// <summary>Converts a draft from one job's place to another's: the program is included, the job's own files keep their plain names,
    /// and other files are referenced by a relative path.</summary>
    public static MatingDraft Moved(MatingDraft draft, CellJobSettings from, CellJobSettings to)
    {
        var (program, dialect) = (draft[DraftPaths.Program].Trim(), draft[DraftPaths.Dialect]);
        return (draft with { Program = draft.Program ?? DraftProgram.Of(ProgramAt(PathOf(from, program))) })
            .With(DraftPaths.Theoretical, Path.GetFileName(draft[DraftPaths.Theoretical].Trim()))
            .With(DraftPaths.Measured, Way(draft[DraftPaths.Measured]))
            .With(DraftPaths.Program, Path.GetFileName(program))
            .With(DraftPaths.Dialect, NcDialects.IsFile(dialect.Trim()) ? Way(dialect) : dialect)
            .With(DraftPaths.CounterpartMeasured, Way(draft[DraftPaths.CounterpartMeasured]));

        string Way(string name) => string.IsNullOrWhiteSpace(name) || Path.IsPathRooted(name.Trim()) ? name
            : Path.GetRelativePath(Path.GetDirectoryName(to.File)!, PathOf(from, name.Trim())).Replace('\\', '/');
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
        PathOf(job, name) is var path
            && File.Exists(path)
            && !InputFile.Open(path, SharedFile.ReadAllBytes).AsSpan().SequenceEqual(bytes.Span);

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
