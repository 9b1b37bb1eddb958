using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>Refuses limits and uncertainties that no deviation can reach before the job stops: they have no effect, and are usually
/// micrometers. Refuses a gauge that is too coarse for the limits.</summary>
/// <param name="problems">The problems of the job.</param>
internal sealed class LimitCheck(JobProblems problems)
{
    /// <summary>Code of the problem of a gauge so uncertain that the job stops before a deviation is significant.</summary>
    public const string UncertaintyImplausible = "uncertainty-implausible";

    /// <summary>Code of the problem of a gauge whose expanded uncertainty exceeds the width of a feature's limits.</summary>
    public const string GaugeTooCoarse = "gauge-too-coarse";

    /// <summary>Code of the problem of guard bands that leave no value to accept.</summary>
    public const string GuardBandsOverlap = "guard-bands-overlap";

    /// <summary>Checks a job.</summary>
    /// <param name="root">Its document.</param>
    /// <param name="job">The job.</param>
    public void Check(JsonItem root, MatingJob job)
    {
        var most = job.Compensation.LimitMm;
        var features = root["features"].Items;
        for (var i = 0; i < features.Count; i++)
        {
            CheckBand(features[i]["toleranceMm"], job.Features[i].Tolerance, job.Chain, most);
        }

        // Without an alignment, the origin's error shifts every point.
        if (job is { OriginCheck.LimitMm: var off, Alignment.Kind: JobAlignmentKind.None } && off > most)
        {
            RefuseLimit(root["originCheck"]["limitMm"], off, most, Number(off));
        }

        // Twice the uncertainty is significant with a single point, and plausible up to the limit.
        if (GaugeCapability.ExpandedMm(job) is var expanded && expanded >= most)
        {
            var u = job.Gauge.Uncertainty.CombinedMm;
            var expected = $"less than {Number(Math.Floor(most * u / expanded * 1e4) / 1e4)}";
            var item = root["gauge"]["uncertaintyMm"];
            problems.Add(JsonRefusal.At(item, UncertaintyImplausible, Number(u), expected) with
            {
                Message = $"found a standard uncertainty of {Number(u)} mm; expected {expected} mm, or no deviation is significant up to "
                + $"the {Number(most)} mm where the job stops (\"limitMm\"). µm? {Number(u)} µm are {Number(u / 1000)} mm."
            });
            return;
        }

        for (var i = 0; i < features.Count; i++)
        {
            CheckGauge(features[i]["toleranceMm"], job, job.Features[i]);
        }
    }

    private void CheckGauge(JsonItem item, MatingJob job, JobFeature feature)
    {
        var (band, expanded) = (feature.Tolerance.Band, GaugeCapability.ExpandedMm(job));
        var guard = job.Rule.GuardMm(job.DeviationUncertaintyMm);
        if (GaugeCapability.Exceeds(expanded, band) && !job.Gauge.AcceptsCoarse)
        {
            Add(
                GaugeTooCoarse,
                expanded,
                $"the gauge's uncertainty (k = 2) is {Short(expanded)} mm: it cannot tell a good {feature.Name} from a bad one. Use a "
                    + "better gauge or wider limits, or accept it by \"acceptCoarse\": true under \"gauge\".");
        }
        else if (job.Rule.AcceptanceLimits(band, job.DeviationUncertaintyMm) is null)
        {
            Add(
                GuardBandsOverlap,
                2 * guard,
                $"each guard band is {Short(guard)} mm wide, so no measured value of {feature.Name} could be accepted. Use a better gauge, "
                    + "a larger \"riskPercent\" or the rule \"simple\".");
        }

        void Add(string code, double least, string why)
        {
            var (found, expected) = ($"limits {Short(band.WidthMm)} mm apart", $"at least {Short(Math.Ceiling(least * 1e4) / 1e4)}");
            problems.Add(JsonRefusal.At(item, code, found, expected) with
            {
                Message = $"found {found} for {feature.Name}; expected {expected} mm: {why}"
            });
        }
    }

    private void CheckBand(JsonItem item, JobTolerance tolerance, ToleranceChain? chain, double most)
    {
        var (lower, upper) = (tolerance.Band.LowerMm, tolerance.Band.UpperMm);
        if (tolerance.Source == ToleranceSource.Stated)
        {
            RefuseAbove(item.Items[0], lower);
            RefuseAbove(item.Items[1], upper);
        }
        else if (Math.Max(Math.Abs(lower), Math.Abs(upper)) is var widest && widest > most && chain is not null)
        {
            var link = chain.Links.MaxBy(l => Math.Max(Math.Abs(l.Tolerance.LowerMm), Math.Abs(l.Tolerance.UpperMm)))!;
            var share = $"of which {link.Name} has {Number(link.Tolerance.LowerMm)} to {Number(link.Tolerance.UpperMm)}";
            RefuseLimit(item, widest, most, $"{Number(lower)} to {Number(upper)} from the tolerance chain, {share}");
        }

        void RefuseAbove(JsonItem place, double limit)
        {
            if (Math.Abs(limit) > most)
            {
                RefuseLimit(place, limit, most, Number(limit));
            }
        }
    }

    private void RefuseLimit(JsonItem item, double limit, double most, string found)
    {
        var expected = $"at most {Number(most)}";
        problems.Add(JsonRefusal.At(item, RefusalForms.LimitImplausible.Name, found, expected) with
        {
            Message = $"found {found} mm; expected {expected} mm either way, since the job stops at any larger deviation (\"limitMm\"). "
            + $"µm? {Number(limit)} µm are {Number(limit / 1000)} mm."
        });
    }

    private static string Short(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);

    private static string Number(double value) => value.ToString("0.#########", CultureInfo.InvariantCulture);
}
