using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>Reads the files of a free-form job and lists them, because none of them may be written to.</summary>
public sealed class FreeformFiles
{
    internal const string SurfaceRole = "surface", CutByRole = "cut-by";

    private readonly List<string> _read;
    private readonly List<ReportInput> _inputs = [];

    /// <summary>Reads the job.</summary>
    /// <param name="job">The job's file.</param>
    /// <exception cref="InputException">The file cannot be opened. The job cannot be used.</exception>
    public FreeformFiles(string job)
        : this(InputFile.Freeform(job))
    {
    }

    /// <summary>The files of a job that is already read.</summary>
    public FreeformFiles(FreeformJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        (Job, _read) = (job, [job.File]);
    }

    /// <summary>The job.</summary>
    public FreeformJob Job { get; }

    /// <summary>The job as named in reports.</summary>
    public ReportJob Named => new(Job.Name, Job.WorkOrder, Job.File, Job.Sha256);

    /// <summary>The files that were read.</summary>
    public IReadOnlyList<string> Opened => _read;

    /// <summary>The files that were read other than the job, with their hashes.</summary>
    public IReadOnlyList<ReportInput> Inputs => _inputs;

    /// <summary>The nominal surface.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public PartSurface Surface()
    {
        var file = Job.PathOf(Job.Surface.File);
        return SurfaceReader.Read(SurfaceBytes(), file, Job.Surface.Entity, Job.Surface.OutsideIsUp);
    }

    /// <summary>The file of the nominal surface.</summary>
    /// <exception cref="InputException">It cannot be opened.</exception>
    public byte[] SurfaceBytes() => AtPlace("$.surface", () => Bytes(SurfaceRole, Job.PathOf(Job.Surface.File), SurfaceReader.MaxBytes));

    /// <summary>The measuring plan of the surface, at the stage after which it is measured.</summary>
    public MeasuringPlan Plan(PartSurface surface) => MeasuringPlanner.Plan(surface, Job);

    /// <summary>The points of a file.</summary>
    /// <param name="role">Its role in the report.</param>
    /// <param name="file">The file.</param>
    /// <param name="plan">The plan that it was measured by.</param>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public MeasuredPoints Measured(string role, GivenFile file, MeasuringPlan plan)
    {
        ArgumentNullException.ThrowIfNull(file);
        if (file.Bytes is { } given)
        {
            return MeasuredSurfaceReader.Read(Note(role, file.File, given).Span, file.File, plan, Job.Measuring);
        }

        var source = MeasurementBytes.Read(file.File, Job.Measuring.Format.MaxBytes);
        _read.AddRange(source.Files);
        _inputs.Add(new(role, file.File, source.Sha256));
        return MeasuredSurfaceReader.Read(source, plan, Job.Measuring);
    }

    /// <summary>An existing program.</summary>
    /// <exception cref="InputException">The file cannot be opened.</exception>
    public ReadOnlyMemory<byte> Program(GivenFile file)
    {
        ArgumentNullException.ThrowIfNull(file);
        return Given("program", file).Bytes!.Value;
    }

    /// <summary>The dialect of the probing program. A dialect file is relative to the job's folder.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used, or there is no dialect of this name
    /// (<c>unknown-dialect</c>).</exception>
    public NcDialect MeasuringDialect() => Dialect(Job.Measuring.Dialect, "$.measuring.dialect");

    /// <summary>The dialect of the cutting programs. A dialect file is relative to the job's folder.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used, or there is no dialect of this name
    /// (<c>unknown-dialect</c>).</exception>
    public NcDialect ToolpathDialect() => Dialect(Job.Toolpath.Dialect, "$.toolpath.dialect");

    /// <summary>The template of the probing program: the job's own, which may name a built-in one, or the dialect's.</summary>
    /// <param name="dialect">The dialect of the probing program.</param>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used. The dialect has no built-in template
    /// (<c>unknown-template</c>), or its control does not support tool names (<c>tool-by-name</c>).</exception>
    public ProbingTemplate Template(NcDialect dialect)
    {
        CheckCall(Job.Measuring.Tool, "$.measuring.tool.name", dialect);
        if (Job.Measuring.Template is { } own)
        {
            return ProbingTemplate.Names.Contains(own)
                ? ProbingTemplate.Named(own)
                : ProbingTemplate.Parse(
                    AtPlace("$.measuring.template", () => Bytes("template", Job.PathOf(own), ProbingTemplate.MaxBytes)), Job.PathOf(own));
        }

        try
        {
            return ProbingTemplate.For(dialect);
        }
        catch (InputException e) when (Job.PlaceOf("$.measuring.dialect") is { } place)
        {
            throw Wrong(
                e.Code,
                "$.measuring.dialect",
                place,
                $"the dialect \"{Job.Measuring.Dialect}\", which no probing template is built in for",
                $"one of {string.Join(", ", ProbingTemplate.Names)}, or one of them or a file of your own as \"template\" beside it");
        }
    }

    /// <summary>The template of cutting programs: the job's own, which may name a built-in one, or the dialect's.</summary>
    /// <param name="dialect">The dialect of the programs that cut.</param>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used. Moves cannot be written in the dialect
    /// (<c>unknown-template</c>), or its control does not support tool names (<c>tool-by-name</c>).</exception>
    public FinishingTemplate FinishingTemplate(NcDialect dialect)
    {
        if (!dialect.HasCodes && Job.PlaceOf("$.toolpath.dialect") is { } place)
        {
            throw Wrong(
                "unknown-template",
                "$.toolpath.dialect",
                place,
                $"the dialect \"{Job.Toolpath.Dialect}\", in which no moves are written",
                $"one of {string.Join(", ", Freeform.FinishingTemplate.Names)}");
        }

        CheckCall(Job.Toolpath.Tool, "$.toolpath.tool.name", dialect);
        return Job.Toolpath.Template is not { } own ? Freeform.FinishingTemplate.For(dialect)
            : Freeform.FinishingTemplate.Names.Contains(own) ? Freeform.FinishingTemplate.Named(own)
            : Freeform.FinishingTemplate.Parse(
                AtPlace("$.toolpath.template", () => Bytes("template", Job.PathOf(own), ProgramTemplate.MaxBytes)), Job.PathOf(own));
    }

    /// <summary>The program that cut the measured piece, as stated by the job; null if it states none.</summary>
    /// <exception cref="InputException">The file cannot be opened.</exception>
    public GivenFile? CutBy() =>
        Job.Measuring.CutBy is not { } file ? null : AtPlace("$.measuring.cutBy", () => Given(CutByRole, new(Job.PathOf(file))));

    /// <summary>Adds a program from the caller to the inputs.</summary>
    /// <param name="role">Its role in the report.</param>
    /// <param name="file">The file.</param>
    /// <exception cref="InputException">It cannot be opened.</exception>
    internal GivenFile Given(string role, GivenFile file)
    {
        if (file.Bytes is null)
        {
            _read.Add(file.File);
        }

        return file with { Bytes = Note(role, file.File, file.Bytes ?? InputFile.Program(file.File)) };
    }

    /// <summary>The bytes of a file named by the job or the command line.</summary>
    /// <param name="role">Its role in the report.</param>
    /// <param name="file">The file.</param>
    /// <param name="mostBytes">Size limit.</param>
    /// <exception cref="InputException">The file cannot be opened or is too large.</exception>
    public byte[] Bytes(string role, string file, long mostBytes)
    {
        _read.Add(file);
        var bytes = InputFile.Bytes(file, mostBytes);
        _ = Note(role, file, bytes);
        return bytes;
    }

    /// <summary>The bytes of a file from the caller.</summary>
    internal ReadOnlyMemory<byte> Bytes(string role, GivenFile file, long mostBytes) =>
        file.Bytes is { } given ? Note(role, file.File, given) : Bytes(role, file.File, mostBytes);

    private NcDialect Dialect(string name, string path)
    {
        if (!NcDialects.IsFile(name))
        {
            return NcDialects.Names.Contains(name) || Job.PlaceOf(path) is not { } place
                ? NcDialects.Named(name)
                : throw Wrong(
                    "unknown-dialect",
                    path,
                    place,
                    $"the dialect \"{name}\"",
                    NcDialects.ExpectedInsteadOf(name));
        }

        var dialect = AtPlace(path, () => InputFile.Dialect(Job.PathOf(name)));
        _read.AddRange(dialect.Files.Select(f => f.File));
        _inputs.AddRange(dialect.Files.Select(f => new ReportInput("dialect", f.File, f.Sha256)));
        return dialect;
    }

    private void CheckCall(ToolCall? tool, string path, NcDialect dialect)
    {
        if (tool?.Name is { } name && !dialect.CallsToolsByName && Job.PlaceOf(path) is { } place)
        {
            throw Wrong(
                "tool-by-name",
                path,
                place,
                $"the tool \"{name}\" by its name, which {dialect.Name} does not know",
                "\"number\" in its place");
        }
    }

    // Adds the place in the job to the error of a file that cannot be opened.
    private T AtPlace<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (InputException e) when (e.Code == MeasurementError.FileUnreadable && Job.PlaceOf(path) is { } place)
        {
            throw InputRefusals.NamedAt(Job.File, path, place, e);
        }
    }

    private InputException Wrong(string code, string path, JsonPlace place, string found, string expected) =>
        new(Job.File, [JsonRefusal.At(place, path, code, found, expected)]);

    private ReadOnlyMemory<byte> Note(string role, string file, ReadOnlyMemory<byte> bytes)
    {
        _inputs.Add(new(role, file, ContentHash.Sha256(bytes.Span)));
        return bytes;
    }
}
