using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <content>Refuses limits and uncertainties that no deviation can reach before the job stops. They have no effect, and are usually
/// micrometers.</content>
internal sealed partial class JobReader
{
    private void CheckLimits(MatingJob job)
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

        // A deviation is significant beyond the expanded uncertainty and plausible up to the limit.
        var factor = Decider.CoverageFactor * (job.Compensation.From == CompensationSource.Counterpart ? Math.Sqrt(2) : 1);
        if (factor * job.Gauge.Uncertainty.CombinedMm is var expanded && expanded >= most)
        {
            var u = job.Gauge.Uncertainty.CombinedMm;
            var expected = $"less than {Number(Math.Floor(most / factor * 1e4) / 1e4)}";
            var item = root["gauge"]["uncertaintyMm"];
            Problems.Add(JsonRefusal.At(item, UncertaintyImplausible, Number(u), expected) with
            {
                Message = $"found a standard uncertainty of {Number(u)} mm; expected {expected} mm, or no deviation is significant up to the "
                + $"{Number(most)} mm where the job stops (\"limitMm\"). um? {Number(u)} um are {Number(u / 1000)} mm."
            });
        }
    }

    private void CheckBand(JsonItem item, JobTolerance tolerance, ToleranceChain? chain, double most)
    {
        var (lower, upper) = (tolerance.Band.LowerMm, tolerance.Band.UpperMm);
        if (tolerance.Source == ToleranceSource.Stated)
        {
            foreach (var (limit, place) in new[] { lower, upper }.Zip(item.Items).Where(l => Math.Abs(l.First) > most))
            {
                RefuseLimit(place, limit, most, Number(limit));
            }
        }
        else if (Math.Max(Math.Abs(lower), Math.Abs(upper)) is var widest && widest > most && chain is not null)
        {
            var link = chain.Links.MaxBy(l => Math.Max(Math.Abs(l.Tolerance.LowerMm), Math.Abs(l.Tolerance.UpperMm)))!;
            var share = $"of which {link.Name} has {Number(link.Tolerance.LowerMm)} to {Number(link.Tolerance.UpperMm)}";
            RefuseLimit(item, widest, most, $"{Number(lower)} to {Number(upper)} from the tolerance chain, {share}");
        }
    }

    private void RefuseLimit(JsonItem item, double limit, double most, string found)
    {
        var expected = $"at most {Number(most)}";
        Problems.Add(JsonRefusal.At(item, RefusalForms.LimitImplausible.Name, found, expected) with
        {
            Message = $"found {found} mm; expected {expected} mm either way, since the job stops at any larger deviation (\"limitMm\"). "
            + $"um? {Number(limit)} um are {Number(limit / 1000)} mm."
        });
    }

    private static string Number(double value) => value.ToString("0.#########", CultureInfo.InvariantCulture);
}
