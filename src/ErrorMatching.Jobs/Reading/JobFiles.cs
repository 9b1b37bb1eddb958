using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads the files of a mating job and lists them, because none of them may be written to.</summary>
public sealed class JobFiles
{
    private readonly List<string> _read;

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

    /// <summary>The files that were read.</summary>
    public IReadOnlyList<string> Read => _read;

    /// <summary>The nominal key points: the given ones, or the job's.</summary>
    /// <exception cref="InputException">The file cannot be used.</exception>
    public MeasurementFile Theoretical(GivenFile? given = null) =>
        Measured(given ?? new(Job.PathOf(Job.Part.Theoretical)), MeasurementFormat.Points);

    /// <summary>A measurement of the part: the given one, or the job's.</summary>
    /// <exception cref="InputException">The file cannot be used. The job's rules say that it is of the counterpart.</exception>
    public MeasurementFile Part(GivenFile? given) => Recognized(given ?? new(Job.PathOf(Job.Part.Measured)), SourceSide.Part);

    /// <summary>A measurement of a counterpart.</summary>
    /// <exception cref="InputException">The file cannot be used. The job's rules say that it is of the part.</exception>
    public MeasurementFile Counterpart(GivenFile file) => Recognized(file, SourceSide.Counterpart);

    /// <summary>The counterpart's program: the given one, or the job's.</summary>
    /// <exception cref="InputException">The file cannot be opened.</exception>
    public (string File, ReadOnlyMemory<byte> Bytes) Program(GivenFile? given)
    {
        var file = given ?? new(Job.PathOf(Job.Counterpart.Program));
        if (file.Bytes is { } bytes)
        {
            return (file.File, bytes);
        }

        _read.Add(file.File);
        return (file.File, InputFile.Program(file.File));
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

    private MeasurementFile Recognized(GivenFile file, SourceSide expected)
    {
        var measurement = Measured(file, Job.Gauge.Format);
        return Job.Recognition is null || Job.Recognition.Decide(measurement) == expected
            ? measurement
            : throw InputRefusals.WrongPiece(file.File, expected);
    }

    private MeasurementFile Measured(GivenFile file, MeasurementFormat format)
    {
        if (file.Bytes is { } bytes)
        {
            return MeasurementReader.Read(bytes, file.File, format);
        }

        var source = MeasurementBytes.Read(file.File, MeasurementReader.LimitOf(format));
        _read.AddRange(source.Files);
        return MeasurementReader.Read(source, format);
    }
}
