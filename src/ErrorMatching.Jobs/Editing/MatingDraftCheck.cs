using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds the problems of a draft with the readers of its files and assigns them to its fields: first the job, then the
/// theoretical points. If both are usable, it also maps every key point to the program, for a part that measures exactly as
/// designed.</summary>
public static class MatingDraftCheck
{
    /// <summary>Checks a draft. Slow with a long program, so do not call it on the UI thread.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="file">The job's file, for relative paths; it need not exist.</param>
    public static DraftCheck Run(MatingDraft draft, string file)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var problems = new List<DraftProblem>();
        var doubts = new List<DraftProblem>();
        MatingJob? job = null;
        try
        {
            job = MatingJob.Parse(MatingDraftFiles.Job(draft), file);
        }
        catch (InputException e)
        {
            problems.AddRange(
                e.Refusals.Where(p => p.Code != DraftLimits.ReversedTolerance).Select(p => new DraftProblem(
                    FieldOf(p), p.Code, p.Found, p.Message, p.Expected)));
        }

        problems.AddRange(DraftLimits.Reversed(draft));
        var theoretical = DraftPoints.Check(draft, job, problems);
        var dialect = job is null ? null : Find(job, problems);
        ReadOnlyMemory<byte>? program = null;
        if (job is not null || draft.Program is not null)
        {
            Read(draft, file, out program, problems);
        }

        if (problems.Count == 0 && job is not null && theoretical is not null && program is { } bytes)
        {
            Map(
                draft,
                new(job, theoretical, theoretical, theoretical, Path.GetFileName(job.Counterpart.Program), bytes)
                {
                    OwnDialect = dialect,
                    Library = new JobFiles(job).Called().Find,
                },
                problems,
                doubts);
            if (problems.Exists(p => p.Code == NcRefusalCodes.BlockNotFound))
            {
                // The mapping does not report that a range runs backward.
                problems.Clear();
                problems.AddRange(DraftBlocks.Check(draft, file, bytes));
            }
        }
        else if (program is { } given)
        {
            // Report problems of the program and its blocks before everything else is right.
            problems.AddRange(DraftBlocks.Check(draft, file, given));
        }

        if (job is not null && MissingMeasured.Of(job) is { } measured)
        {
            doubts.Add(new(MissingMeasured.Path, measured.Code, job.Counterpart.Measured!, measured.Message));
        }

        if (job is not null)
        {
            doubts.AddRange(GaugeCapability.ItemsOf(job).Select(
                w => new DraftProblem(w.Place.Path!, w.Code, w.Found, w.Message, w.Expected)));
        }

        return new([.. problems.Select(p => DraftMissing.Marked(draft, p))], job) { Doubts = doubts };
    }

    /// <summary>The program of a draft that may have other problems: the imported one, otherwise the job's.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="file">The job's file, for relative paths.</param>
    /// <exception cref="InputException">The job's program cannot be opened. It is larger than the limit for programs.</exception>
    public static ReadOnlyMemory<byte> ProgramOf(MatingDraft draft, string file)
    {
        ArgumentNullException.ThrowIfNull(draft);
        return draft.Program?.Bytes ?? InputFile.Program(Beside(file, draft[DraftPaths.Program]));
    }

    /// <summary>The dialect of a draft that may have other problems.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="file">The job's file, for relative paths.</param>
    /// <exception cref="InputException">The shop's dialect file cannot be opened. It cannot be used. No dialect has this
    /// name.</exception>
    public static NcDialect DialectOf(MatingDraft draft, string file)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var name = draft[DraftPaths.Dialect];
        var assumed = draft.Document.Parts(DraftPaths.Assumed)
            .Select(v => AssumedValues.Read($"{v.Name}={v.Text}"))
            .OfType<KeyValuePair<string, double>>();
        return InputFile.Dialect(NcDialects.IsFile(name) ? Beside(file, name) : name)
            .With(BlockSkips.Of(draft[DraftPaths.BlockSkip]))
            .With(AssumedValues.Of(assumed));
    }

    private static string Beside(string file, string name) => Path.Combine(Path.GetDirectoryName(Path.GetFullPath(file))!, name);

    // Null for a built-in dialect.
    private static NcDialect? Find(MatingJob job, List<DraftProblem> problems)
    {
        try
        {
            var dialect = InputFile.DialectOf(job);
            return NcDialects.IsFile(job.Counterpart.Dialect) ? dialect : null;
        }
        catch (InputException e)
        {
            problems.AddRange(e.Refusals.Select(i => At(DraftPaths.Dialect, i)));
            return null;
        }
    }

    private static void Read(MatingDraft draft, string file, out ReadOnlyMemory<byte>? program, List<DraftProblem> problems)
    {
        program = null;
        try
        {
            program = ProgramOf(draft, file);
        }
        catch (InputException e)
        {
            problems.AddRange(e.Refusals.Select(i => At(DraftPaths.Program, i)));
        }
    }

    private static void Map(MatingDraft draft, MatchInput input, List<DraftProblem> problems, List<DraftProblem> doubts)
    {
        try
        {
            var match = Matcher.Match(input);
            problems.AddRange(match.Refusals.Select(
                r => new DraftProblem(FieldOf(draft, r), r.Code, r.Place.Point ?? r.Place.Block ?? "", r.Message) { Amount = r.Found }));
            if (match.Result is { } result)
            {
                doubts.AddRange(DraftDoubts.OfBlocks(result));
                doubts.AddRange(DraftDoubts.OfCorners(draft, result));
            }
        }
        catch (InputException e)
        {
            problems.Add(new(e.File is null ? DraftPaths.Program : DraftPaths.Theoretical, e.Code, e.Refusals[0].Found, e.Problem));
        }
        catch (GeometryException e)
        {
            problems.Add(At(DraftPaths.Features, InputRefusals.Of(e, input.Theoretical.File).Refusals[0]));
        }
    }

    // Report a missing key at the field that would write it.
    private static string FieldOf(Refusal problem) => problem.Code switch
    {
        "stylus-diameter-missing" => DraftPaths.StylusDiameter,
        "measured-missing" => DraftPaths.CounterpartMeasured,
        _ => problem.Place.Path ?? "$",
    };

    private static string FieldOf(MatingDraft draft, Refusal refusal)
    {
        var feature = IndexOf(draft, refusal);
        return feature >= 0
            ? DraftPaths.Feature(feature, FeatureDraft.BlocksKey)
            : refusal.Code == "alignment-needs-one-plane"
            ? DraftPaths.AlignmentKind
            : DraftPaths.Program;
    }

    private static int IndexOf(MatingDraft draft, Refusal refusal) =>
        draft.Features.ToList().FindIndex(f => f.Name.Trim() == refusal.Place.Feature);

    private static DraftProblem At(string field, Refusal item) => new(field, item.Code, "", item.Message);
}

/// <summary>The result of checking a draft.</summary>
/// <param name="Problems">All problems, in the order of the job; empty if it can be saved.</param>
/// <param name="Job">The job; null while its file has problems.</param>
public sealed record DraftCheck(IReadOnlyList<DraftProblem> Problems, MatingJob? Job)
{
    /// <summary>Valid but probably unintended input: questions that do not prevent saving.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; init; } = [];
}

/// <summary>A problem in a draft, and its field.</summary>
/// <param name="Field">The field: a path of <see cref="DraftPaths"/> or of the job.</param>
/// <param name="Code">Stable code of the reader that reports it.</param>
/// <param name="Found">What was found, as the middle of a sentence; empty if <paramref name="Message"/> is complete.</param>
/// <param name="Message">What was found and what is expected, as a sentence.</param>
/// <param name="Expected">What is expected instead, as the middle of a sentence; empty if <paramref name="Message"/> is complete.</param>
public sealed record DraftProblem(string Field, string Code, string Found, string Message, string Expected = "")
{
    /// <summary>True if the field is not wrong, but not filled in yet.</summary>
    public bool IsMissing { get; init; }

    /// <summary>The size of the error, with its unit; empty if it is not measured.</summary>
    public string Amount { get; init; } = "";
}

/// <summary>Reports lower limits that exceed their upper limits, at the lower one. The job's reader reports this only once everything
/// else can be read, and for both limits together.</summary>
internal static class DraftLimits
{
    /// <summary>The code that the job's reader uses.</summary>
    public const string ReversedTolerance = "reversed-tolerance";

    /// <summary>The reversed limits of features and of the tolerance chain.</summary>
    /// <param name="draft">The draft.</param>
    public static IEnumerable<DraftProblem> Reversed(MatingDraft draft)
    {
        var features = draft.Features.Select(
            (_, i) => (Lower: DraftPaths.Feature(i, FeatureDraft.LowerKey), Upper: DraftPaths.Feature(i, FeatureDraft.UpperKey)));
        var chain = Enumerable.Range(0, draft.Count(DraftPaths.Chain)).Select(
            i => (
                Lower: DraftPaths.Item(DraftPaths.Chain, i, FeatureDraft.LowerKey),
                Upper: DraftPaths.Item(DraftPaths.Chain, i, FeatureDraft.UpperKey)));
        return features.Concat(chain).Select(b => (Field: b.Lower, Lower: draft[b.Lower], Upper: draft[b.Upper]))
            .Where(b => DraftNumber.Value(b.Lower) > DraftNumber.Value(b.Upper))
            .Select(b => new DraftProblem(
                b.Field,
                ReversedTolerance,
                $"the limits {b.Lower} and {b.Upper}",
                $"found the limits {b.Lower} and {b.Upper}; expected the lower limit first",
                "the lower limit first"));
    }
}

/// <summary>Distinguishes fields that are not filled in yet from wrong ones.</summary>
internal static class DraftMissing
{
    // How the job's reader reports an empty field.
    private const string NoText = "the text \"\"";

    private static readonly string[] Codes = ["too-short", "empty-cell", "too-few-items", "stylus-diameter-missing", "measured-missing"];

    /// <summary>The problem, marked if the field is only not filled in yet.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="problem">The problem.</param>
    public static DraftProblem Marked(MatingDraft draft, DraftProblem problem) => problem with
    {
        IsMissing = problem.Found == NoText
            || Codes.Contains(problem.Code)
            || (problem.Field == DraftPaths.Program && string.IsNullOrWhiteSpace(draft[DraftPaths.Program])),
    };
}
