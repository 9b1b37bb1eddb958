using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The complete input of a match. The result depends on nothing else.</summary>
/// <param name="Job">The job.</param>
/// <param name="Theoretical">The key points as designed.</param>
/// <param name="Part">The key points as measured on the part.</param>
/// <param name="Counterpart">The key points as measured on a counterpart; needed for feedback, else null.</param>
/// <param name="ProgramFile">The counterpart's program as the caller named it.</param>
/// <param name="Program">Its bytes.</param>
public sealed record MatchInput(
    MatingJob Job,
    MeasurementFile Theoretical,
    MeasurementFile Part,
    MeasurementFile? Counterpart,
    string ProgramFile,
    ReadOnlyMemory<byte> Program)
{
    /// <summary>The program's dialect if the job names a file of the shop (<see cref="NcDialects.IsFile"/>); otherwise null, and the job
    /// names a built-in dialect.</summary>
    public NcDialect? OwnDialect { get; init; }

    /// <summary>In feedback, the match whose program cut the measured counterpart; null if none is known, or a nominal program
    /// did.</summary>
    public PreviousMatch? Previous { get; init; }

    /// <summary>In feedback, the last match of the lot, if other counterparts were measured between <see cref="Previous"/> and this one;
    /// otherwise null.</summary>
    public PreviousMatch? Latest { get; init; }

    /// <summary>True if the tool was changed before the measured counterpart was cut: the process may have moved.</summary>
    public bool ToolChanged { get; init; }

    /// <summary>Returns a called program that is not in the file, by its name; null if there is none. The same name always gives the same
    /// program. If the function itself is null, no other program is known.</summary>
    public Func<string, NcProgram?>? Library { get; init; }

    /// <summary>Name of the file that a program of offsets gets; null for <c>offsets</c> beside the program, as the control wants to call
    /// it.</summary>
    public string? OffsetsFile { get; init; }

    /// <summary>SHA-256 of the program's bytes as 64 lower-case hexadecimal digits.</summary>
    public string ProgramSha256 => ContentHash.Sha256(Program.Span);

    /// <summary>The measurement to compensate: the part's in feed-forward, the counterpart's in feedback.</summary>
    /// <exception cref="ArgumentException">The job is feedback and there is no measured counterpart.</exception>
    public MeasurementFile Compensated => Job.Compensation.From == CompensationSource.Part ? Part : RequireCounterpart();

    /// <summary>The measured counterpart.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public MeasurementFile RequireCounterpart() =>
        Counterpart ?? throw new ArgumentException("Feedback needs a measured counterpart.", nameof(Counterpart));

    /// <summary>Interprets the program in the job's dialect.</summary>
    /// <exception cref="InputException">The dialect is unknown, or the program is too large.</exception>
    public NcPath Interpret() =>
        NcInterpreter.Run(NcProgram.Read(Program), Job.Counterpart.DialectOf(OwnDialect), Library, CancellationToken.None);
}
