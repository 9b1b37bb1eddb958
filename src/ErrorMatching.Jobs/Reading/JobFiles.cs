using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads the files of a mating job and lists them, because none of them may be written to.</summary>
public sealed class JobFiles
{
    private readonly List<string> _read;
    private readonly List<ProgramFolder> _called = [];

    /// <summary>Reads the job.</summary>
    /// <param name="job">The job's file.</param>
    /// <exception cref="InputException">The file cannot be opened. The job cannot be used.</exception>
    public JobFiles(string job)
        : this(InputFile.Job(job))
    {
    }

    /// <summary>The files of a job that is already read.</summary>
    public JobFiles(MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        (Job, _read) = (job, [job.File]);
    }

    /// <summary>The job.</summary>
    public MatingJob Job { get; }

    /// <summary>The files that were opened so far, called programs among them.</summary>
    public IReadOnlyList<string> Opened => [.. _read, .. _called.SelectMany(c => c.Opened)];

    /// <summary>The nominal key points: the given ones, or the job's.</summary>
    /// <exception cref="InputException">The file cannot be used.</exception>
    public MeasurementFile Theoretical(GivenFile? given = null)
    {
        var file = Measured(given ?? new(Job.PathOf(Job.Part.Theoretical)), MeasurementFormat.Points);
        return file.IsByOrder
            ? throw MeasurementRefusal.Of(
                MeasurementError.MissingColumn,
                "a log without labels",
                "the key points as designed, with their labels: point,x_mm,y_mm",
                file.File,
                1,
                1)
            : file;
    }

    /// <summary>A measurement of the part: the given one, or the job's.</summary>
    /// <param name="given">The measurement; null for the job's.</param>
    /// <param name="theoretical">The nominal key points, which give a log its labels; null for the job's.</param>
    /// <exception cref="InputException">The file cannot be used. The job's rules say that it is of the counterpart, or its content is that
    /// of the job's measured counterpart.</exception>
    public MeasurementFile Part(GivenFile? given, MeasurementFile? theoretical = null)
    {
        var part = Recognized(given ?? new(Job.PathOf(Job.Part.Measured)), SourceSide.Part, theoretical);
        return Job.Counterpart.Measured is { } measured && HasContent(Job.PathOf(measured), part.Sha256)
            ? throw InputRefusals.SameContent(part.File, SourceSide.Part, measured)
            : part;
    }

    /// <summary>A measurement of a counterpart.</summary>
    /// <param name="file">The measurement.</param>
    /// <param name="part">The measured part, whose content must not be the counterpart's; null if none was read.</param>
    /// <param name="theoretical">The nominal key points, which give a log its labels; null for the job's.</param>
    /// <exception cref="InputException">The file cannot be used. The job's rules say that it is of the part, or its content is that of the
    /// part's file.</exception>
    public MeasurementFile Counterpart(GivenFile file, MeasurementFile? part, MeasurementFile? theoretical = null)
    {
        var counterpart = Recognized(file, SourceSide.Counterpart, theoretical);
        if (part is not null)
        {
            CheckPieces(part, counterpart);
        }

        return counterpart;
    }

    /// <summary>Checks that what is compared are two measurements. A copy of the part's would fit it perfectly.</summary>
    /// <param name="part">The measured part.</param>
    /// <param name="counterpart">The measured counterpart.</param>
    /// <exception cref="InputException">Both have the same content.</exception>
    public static void CheckPieces(MeasurementFile part, MeasurementFile counterpart)
    {
        ArgumentNullException.ThrowIfNull(part);
        ArgumentNullException.ThrowIfNull(counterpart);
        if (part.Sha256 == counterpart.Sha256)
        {
            throw InputRefusals.SameContent(counterpart.File, SourceSide.Counterpart, part.File);
        }
    }

    /// <summary>Checks that a measured part is not where the counterpart's program has it.</summary>
    /// <param name="theoretical">The nominal key points.</param>
    /// <param name="part">The measured part.</param>
    /// <exception cref="InputException">Without an alignment, a key point is further than the job's limit from its nominal place, while all
    /// of them are within the limit of their places in the program.</exception>
    public void CheckFrame(MeasurementFile theoretical, MeasurementFile part)
    {
        ArgumentNullException.ThrowIfNull(theoretical);
        ArgumentNullException.ThrowIfNull(part);
        var (frame, limit) = (Job.Counterpart.Frame, Job.Compensation.LimitMm);
        if (Job.Alignment.Kind != JobAlignmentKind.None
            || frame == RigidTransform2.Identity
            || Job.Features.Any(f => f.Plane != CoordinatePlane.XY))
        {
            return;
        }

        var (off, offInProgram) = (0.0, 0.0);
        foreach (var label in Job.KeyPoints)
        {
            if (!theoretical.TryGet(label, out var nominal) || !part.TryGet(label, out var actual))
            {
                return;
            }

            var (wanted, found) = (new Point2(nominal.Position.X, nominal.Position.Y), new Point2(actual.Position.X, actual.Position.Y));
            off = Math.Max(off, (found - wanted).Length);
            offInProgram = Math.Max(offInProgram, (found - frame.Apply(wanted)).Length);
        }

        if (off > limit && offInProgram <= limit)
        {
            throw InputRefusals.CounterpartFrame(part.File);
        }
    }

    /// <summary>The counterpart's program: the given one, or the job's.</summary>
    /// <exception cref="InputException">The file cannot be opened. There is nothing in it, or no text that a control reads.</exception>
    public (string File, ReadOnlyMemory<byte> Bytes) Program(GivenFile? given)
    {
        var file = given ?? new(Job.PathOf(Job.Counterpart.Program));
        if (file.Bytes is { } bytes)
        {
            return (file.File, InputFile.Checked(file.File, bytes));
        }

        _read.Add(file.File);
        return (file.File, InputFile.Program(file.File));
    }

    /// <summary>Adds a file that was read beside the job's own.</summary>
    internal void Add(string file) => _read.Add(file);

    /// <summary>The folders of the programs that the job's program calls: its own, and the job's libraries.</summary>
    public ProgramFolder Called()
    {
        var called = new ProgramFolder(Job.PathOf(Job.Counterpart.Program), [.. Job.Counterpart.Libraries.Select(Job.PathOf)]);
        _called.Add(called);
        return called;
    }

    /// <summary>The dialect of the program if the job names a dialect file; otherwise null.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public NcDialect? OwnDialect()
    {
        if (!NcDialects.IsFile(Job.Counterpart.Dialect))
        {
            return null;
        }

        var dialect = InputFile.DialectOf(Job);
        _read.AddRange(dialect.Files.Select(f => f.File));
        return dialect;
    }

    // A counterpart that is not there, or cannot be read, is refused where it is needed.
    private bool HasContent(string path, string sha256)
    {
        try
        {
            return File.Exists(path) && MeasurementBytes.Read(path, Job.Gauge.Format.MaxBytes).Sha256 == sha256;
        }
        catch (InputException)
        {
            return false;
        }
    }

    /// <summary>The counterpart's program, interpreted as a match does it.</summary>
    /// <exception cref="InputException">The program, one that it calls, or the job's own dialect cannot be used.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    internal InterpretedProgram Interpret(CancellationToken cancellation)
    {
        var (file, bytes) = Program(null);
        var (own, called) = (OwnDialect(), Called());
        cancellation.ThrowIfCancellationRequested();
        var path = NcInterpreter.Run(NcProgram.Read(bytes), Job.Counterpart.DialectOf(own), called.Find, cancellation);
        return new(file, bytes, own, called, path);
    }

    private MeasurementFile Recognized(GivenFile file, SourceSide expected, MeasurementFile? theoretical)
    {
        var measurement = WithLabels(Measured(file, Job.Gauge.Format), expected, theoretical);
        return Job.Recognition is null || Job.Recognition.Decide(measurement) == expected
            ? measurement
            : throw InputRefusals.WrongPiece(file.File, expected);
    }

    // Labels of the job for a file that has other ones, or none.
    private MeasurementFile WithLabels(MeasurementFile measurement, SourceSide expected, MeasurementFile? theoretical) =>
        measurement.Plan is { } plan ? Probed(plan, measurement, expected, theoretical ?? Theoretical())
        : measurement.IsByOrder ? measurement.InOrderOf(Order(measurement.Points.Count, theoretical))
        : Job.Gauge.Labels is { } rule ? measurement.Renamed(rule, Job.NeededPoints)
        : measurement;

    // The log of a probing program says for which points it was made, and of which piece. The counterpart was touched where its program
    // has it.
    private MeasurementFile Probed(string plan, MeasurementFile measurement, SourceSide expected, MeasurementFile theoretical)
    {
        var (part, counterpart) = (TouchOrder.PlanOf(Job, theoretical), TouchOrder.PlanOfCounterpart(Job, theoretical));
        if (plan != part && plan != counterpart)
        {
            throw new InputException(Refusal.Of(
                "other-plan",
                $"a log of the plan {PrintedText.OneLine(plan)}",
                $"one of the plan {(expected == SourceSide.Part ? part : counterpart)}, which is that of this job: its points, or their "
                    + "order, were others when the probing program was made",
                new() { File = measurement.File, Line = 1, Column = 1 }));
        }

        if (plan == part != (expected == SourceSide.Part))
        {
            throw InputRefusals.WrongPiece(measurement.File, expected, "the plan in its first line");
        }

        var named = measurement.InOrderOf(TouchOrder.Labels(Job, theoretical));
        return expected == SourceSide.Part ? named : named.Moved(Job.Counterpart.Frame.Inverse());
    }

    // The theoretical file may have more points than the job needs. The number of points tells whether all of them were measured.
    private IReadOnlyList<string> Order(int count, MeasurementFile? theoretical)
    {
        if (Job.Gauge.Order.Count > 0)
        {
            return Job.Gauge.Order;
        }

        var all = (theoretical ?? Theoretical()).Points.Select(p => p.Label).ToArray();
        var needed = Job.NeededPoints.ToHashSet(StringComparer.Ordinal);
        return count == all.Length ? all : [.. all.Where(needed.Contains)];
    }

    private MeasurementFile Measured(GivenFile file, MeasurementFormat format)
    {
        if (file.Bytes is { } bytes)
        {
            return MeasurementReader.Read(bytes, file.File, format);
        }

        var source = MeasurementBytes.Read(file.File, format.MaxBytes);
        _read.AddRange(source.Files);
        return MeasurementReader.Read(source, format);
    }
}

/// <summary>A job's program, interpreted.</summary>
/// <param name="File">The program as a path from the caller's folder.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="OwnDialect">The job's dialect if it names a file of the shop; otherwise null.</param>
/// <param name="Called">The programs that it calls.</param>
/// <param name="Path">Its path.</param>
internal sealed record InterpretedProgram(
    string File, ReadOnlyMemory<byte> Bytes, NcDialect? OwnDialect, ProgramFolder Called, NcPath Path);
