using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The fit of a curve.</summary>
/// <param name="Degree">Degree of the polynomial, given or chosen.</param>
/// <param name="Ridge">Weight against overfitting, given or chosen.</param>
/// <param name="LeaveOneOutMm">Root mean square error when each point is left out; null if every point is needed.</param>
/// <param name="ResidualStandardDeviationMm">Standard deviation of the residuals.</param>
public sealed record ReportCurve(int Degree, double Ridge, double? LeaveOneOutMm, double ResidualStandardDeviationMm)
{
    /// <summary>Creates the report's view of a fit.</summary>
    public static ReportCurve Of(CurveFit fit)
    {
        ArgumentNullException.ThrowIfNull(fit);
        return new(fit.Polynomial.Degree, fit.Polynomial.Ridge, fit.Polynomial.LeaveOneOutRms, fit.ResidualStandardDeviation);
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Count("degree", Degree);
        w.Exact("ridge", Ridge);
        w.Number("leaveOneOutMm", LeaveOneOutMm);
        w.Number("residualStandardDeviationMm", ResidualStandardDeviationMm);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportCurve Read(ReportReader r) => new(
        r.Count("degree"), r.Number("ridge"), r.OptionalNumber("leaveOneOutMm"), r.Number("residualStandardDeviationMm"));
}
