using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The fit of the systematic error in a report. Lengths in millimeters.</summary>
/// <param name="BreaksU">Parameters u at which the curvature of the field jumps.</param>
/// <param name="BreaksV">Parameters v at which the curvature of the field jumps.</param>
/// <param name="LeaveLineOutMm">Mean error where whole grid lines are predicted from the others; null if that is unknown.</param>
/// <param name="ResidualStandardDeviationMm">Standard deviation of the residuals; null if it is unknown.</param>
/// <param name="NoiseMm">Standard deviation of the noise of one sample; null if it is unknown.</param>
public sealed record FindingsFit(
    IReadOnlyList<double> BreaksU,
    IReadOnlyList<double> BreaksV,
    double? LeaveLineOutMm,
    double? ResidualStandardDeviationMm,
    double? NoiseMm)
{
    /// <summary>The fit of a field.</summary>
    public static FindingsFit Of(FittedField field)
    {
        ArgumentNullException.ThrowIfNull(field);
        return new(
            field.BreaksU, field.BreaksV, Known(field.LeaveLineOutMm), Known(field.ResidualStandardDeviationMm), Known(field.NoiseMm));
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter json)
    {
        json.Numbers("breaksU", BreaksU);
        json.Numbers("breaksV", BreaksV);
        json.Number("leaveLineOutUm", LeaveLineOutMm * 1000);
        json.Number("residualStandardDeviationUm", ResidualStandardDeviationMm * 1000);
        json.Number("noiseUm", NoiseMm * 1000);
    }

    /// <summary>Reads what <see cref="Write"/> writes; null if it was not written.</summary>
    internal static FindingsFit? Read(ReportReader json) => !json.Names.Contains("breaksU") ? null : new(
        json.Numbers("breaksU"),
        json.Numbers("breaksV"),
        json.OptionalNumber("leaveLineOutUm") / 1000,
        json.OptionalNumber("residualStandardDeviationUm") / 1000,
        json.OptionalNumber("noiseUm") / 1000);

    // Points on only two lines have no line-out error.
    private static double? Known(double mm) => double.IsFinite(mm) ? mm : null;
}
