using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Compares the gauge with the tolerance of each feature: its expanded uncertainty (k = 2) should not exceed a third of the width
/// of the limits.</summary>
/// <remarks>Limits without width ask for a correction of every significant deviation. They have no tolerance to compare a gauge
/// with.</remarks>
public static class GaugeCapability
{
    // A difference beyond the 9th digit is rounding.
    private const double Rounding = 1 + 1e-9;

    /// <summary>The warnings of a job, one for each feature that the gauge is too coarse for, with their places.</summary>
    /// <param name="job">The job.</param>
    public static IReadOnlyList<Refusal> ItemsOf(MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return [
            .. Doubtful(job).Select(f => new Refusal(f.Warning.Code, f.Warning.Message, new()
            {
                File = job.File,
                Feature = job.Features[f.Feature].Name,
                Line = job.Features[f.Feature].Tolerance.Place?.Line,
                Column = job.Features[f.Feature].Tolerance.Place?.Column,
                Path = string.Create(CultureInfo.InvariantCulture, $"$.features[{f.Feature}].toleranceMm"),
            })
            {
                Found = f.Warning.Values[1],
            })];
    }

    /// <summary>The same warnings for a report.</summary>
    /// <param name="job">The job.</param>
    internal static IEnumerable<ReportWarning> WarningsOf(MatingJob job) => Doubtful(job).Select(f => f.Warning);

    /// <summary>The expanded uncertainty (k = 2) of the deviation that decisions are based on, mm.</summary>
    /// <param name="job">The job.</param>
    internal static double ExpandedMm(MatingJob job) => UncertaintyBudget.CoverageFactor * job.DeviationUncertaintyMm;

    /// <summary>True if an expanded uncertainty exceeds a number of parts of the width of limits that have one.</summary>
    internal static bool Exceeds(double expandedMm, ToleranceBand limits, int parts = 1) =>
        limits.WidthMm > 0 && expandedMm * parts > limits.WidthMm * Rounding;

    private static IEnumerable<(int Feature, ReportWarning Warning)> Doubtful(MatingJob job)
    {
        var expanded = ExpandedMm(job);
        for (var i = 0; i < job.Features.Count; i++)
        {
            var (name, band) = (job.Features[i].Name, job.Features[i].Tolerance.Band);
            if (Exceeds(expanded, band, parts: 3))
            {
                yield return (i, WarningForms.Warning(
                    WarningForms.GaugeCoarse, name, Number(expanded), Number(band.WidthMm), Percent(expanded / band.WidthMm)));
            }
        }
    }

    private static string Number(double mm) => mm.ToString("0.####", CultureInfo.InvariantCulture);

    private static string Percent(double share) => ReportNumber.WholePercent(share * 100);
}
