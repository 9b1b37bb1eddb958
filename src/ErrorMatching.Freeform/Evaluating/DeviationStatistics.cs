namespace ErrorMatching.Freeform;

/// <summary>Statistics of deviations of a surface along its normal. Lengths in millimeters.</summary>
/// <param name="Count">Number of points.</param>
/// <param name="MeanMm">Mean deviation, positive out of the material.</param>
/// <param name="StandardDeviationMm">Standard deviation with n - 1; zero for one point.</param>
/// <param name="ProfileIsoMm">Profile of a surface to ISO 1101 with a zone centered on the nominal surface: twice the largest absolute
/// deviation.</param>
/// <param name="ProfileRangeMm">Largest minus smallest deviation.</param>
public sealed record DeviationStatistics(int Count, double MeanMm, double StandardDeviationMm, double ProfileIsoMm, double ProfileRangeMm)
{
    /// <summary>Calculates the statistics of deviations.</summary>
    /// <param name="deviationsMm">At least one.</param>
    /// <exception cref="ArgumentException">There are no deviations.</exception>
    public static DeviationStatistics Of(IReadOnlyCollection<double> deviationsMm)
    {
        ArgumentNullException.ThrowIfNull(deviationsMm);
        if (deviationsMm.Count == 0)
        {
            throw new ArgumentException("No deviations.", nameof(deviationsMm));
        }

        var mean = deviationsMm.Sum() / deviationsMm.Count;
        var squares = deviationsMm.Sum(d => (d - mean) * (d - mean));
        return new(
            deviationsMm.Count,
            mean,
            deviationsMm.Count > 1 ? Math.Sqrt(squares / (deviationsMm.Count - 1)) : 0,
            2 * deviationsMm.Max(Math.Abs),
            deviationsMm.Max() - deviationsMm.Min());
    }
}
