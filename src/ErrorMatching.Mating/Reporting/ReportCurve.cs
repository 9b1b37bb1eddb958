using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>How a curve was fitted.</summary>
/// <param name="Degree">Degree of the polynomial, given or chosen.</param>
/// <param name="Ridge">Weight against overfitting, given or chosen.</param>
/// <param name="LeaveOneOutMm">Root mean square error when each point is left out; null where every point is needed.</param>
/// <param name="ResidualStandardDeviationMm">What the fit leaves.</param>
public sealed record ReportCurve(int Degree, double Ridge, double? LeaveOneOutMm, double ResidualStandardDeviationMm)
{
    /// <summary>What a report says of a fit.</summary>
    public static ReportCurve Of(CurveFit fit)
    {
        ArgumentNullException.ThrowIfNull(fit);
        return new(fit.Polynomial.Degree, fit.Polynomial.Ridge, fit.Polynomial.LeaveOneOutRms, fit.ResidualStandardDeviation);
    }
}
