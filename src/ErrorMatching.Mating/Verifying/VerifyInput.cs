using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The complete input of a verification.</summary>
/// <param name="Job">The job.</param>
/// <param name="Theoretical">The key points as designed.</param>
/// <param name="Part">The key points as measured on the part.</param>
/// <param name="Before">The key points as measured on the counterpart cut without compensation; null to use the designed one.</param>
/// <param name="After">The key points as measured on the counterpart cut with compensation.</param>
/// <param name="ProgramFile">The counterpart's nominal program, as the caller named it; its path gives the normals.</param>
/// <param name="Program">Its bytes.</param>
public sealed record VerifyInput(
    MatingJob Job,
    MeasurementFile Theoretical,
    MeasurementFile Part,
    MeasurementFile? Before,
    MeasurementFile After,
    string ProgramFile,
    ReadOnlyMemory<byte> Program)
{
    /// <summary>The program's dialect if the job names a file of the shop (<see cref="NcDialects.IsFile"/>); otherwise null, and the job
    /// names a built-in dialect.</summary>
    public NcDialect? OwnDialect { get; init; }

    /// <summary>Returns a called program that is not in the file, as for a match.</summary>
    public Func<string, NcProgram?>? Library { get; init; }
}
