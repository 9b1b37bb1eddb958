using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Everything a verification is computed from.</summary>
/// <param name="Job">The job.</param>
/// <param name="Theoretical">The key points as designed.</param>
/// <param name="Part">The key points as measured on the part.</param>
/// <param name="Before">The key points as measured on the counterpart that was cut without compensation;
/// null where none is measured, and it is taken as designed.</param>
/// <param name="After">The key points as measured on the counterpart that was cut with it.</param>
/// <param name="ProgramFile">The counterpart's nominal program as the caller named it; its path gives the normals.</param>
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
    /// <summary>The dialect of the program where the job names a file of the shop (<see cref="NcDialects.IsFile"/>);
    /// else null, and the job's name says which.</summary>
    public NcDialect? OwnDialect { get; init; }
}
