using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Decides how each feature is compensated (Wang 2021, section 2.4): not at all inside the tolerance, by the whole deviation or
/// its excess outside. Implausible deviations refuse the job.</summary>
/// <remarks>
/// <para>A feature is outside its tolerance if the normal deviation of any of its points is outside the acceptance limits
/// (<see cref="DecisionRule"/>). All its points are then compensated, because moving only part of a line would bend it.</para>
/// <para>The deviation of such a point, or what the points have in common, must also be significant (<see cref="Significance"/>) against
/// the combined standard uncertainty u of a normal deviation (<see cref="MatingJob.DeviationUncertaintyMm"/>). In feedback with several
/// counterparts, what they say of the next one decides (<see cref="CounterpartLot"/>).</para>
/// <para>Limits that are wider than <see cref="UsualTolerance"/> and more than <see cref="MostTolerance"/> times a significant deviation
/// of the feature are refused, because they are probably micrometers entered as millimeters. A tolerance may well be wider than the
/// deviations of a good piece: by a factor of 50 if 0.05 mm are allowed and 1 um is found. Micrometers read as millimeters are off by a
/// factor of 1000. Deviations that are not significant are not compensated and do not test the limits.</para>
/// <para>A displacement is plausible up to the job's limit, in any direction. A larger one at any point refuses the job.</para>
/// </remarks>
internal static class Decider
{
    /// <summary>Largest ratio of a limit to the feature's deviation that is accepted without question.</summary>
    public const double MostTolerance = 100;

    /// <summary>Limits up to this value, mm, are usual; as micrometers they would be finer than any cut.</summary>
    public const double UsualTolerance = 1;

    /// <summary>Decides on all features of a job.</summary>
    /// <param name="job">The job, with features, tolerances, uncertainty and compensation.</param>
    /// <param name="points">For each feature of the job, in its order, the key points in the order of cutting.</param>
    /// <param name="lot">The counterparts so far; null in feed-forward.</param>
    /// <exception cref="ArgumentException">The lists do not match the job's features and points.</exception>
    public static MatingDecision Decide(MatingJob job, IReadOnlyList<IReadOnlyList<BoundaryPoint>> points, CounterpartLot? lot = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(points);
        var u = lot?.UncertaintyMm(job) ?? job.DeviationUncertaintyMm;
        var acceptance = job.Features.Select(f => job.Rule.AcceptanceLimits(f.Tolerance.Band, Math.Min(u, job.DeviationUncertaintyMm))
            ?? throw new ArgumentException($"The guard bands of {f.Name} overlap; expected a checked job.", nameof(job))).ToArray();
        for (var i = 0; i < job.Features.Count; i++)
        {
            if (points.Count != job.Features.Count || !job.Features[i].Points.SequenceEqual(points[i].Select(p => p.Label)))
            {
                throw new ArgumentException(
                    $"Found other points than those of {job.Features[i].Name}; expected its key points in the order of cutting.",
                    nameof(points));
            }
        }

        // What a lot says of the next counterpart is not the noise of one measurement.
        var significant = lot?.WorthMm
            ?? (u * Significance.Factor([.. acceptance.Select((a, i) => (a, job.Features[i].Points.Count))], u));
        bool[] alone = [
            .. points.Select((p, i) => p.Any(b => !acceptance[i].Contains(b.DecidedMm) && Math.Abs(b.FollowedMm) > significant))];
        var together = lot?.WorthMm is null
            ? Significance.Together(
                [.. points.Select(f => f.Select(SignificantPoint.Of).ToArray())], alone, u, job.DeviationUncertaintySharedMm)
            : new bool[alone.Length];
        var features = new List<FeatureDecision>();
        var refusals = new List<Refusal>();
        for (var i = 0; i < job.Features.Count; i++)
        {
            var feature = job.Features[i];
            features.Add(Decide(feature, acceptance[i], points[i], job.Compensation, u, significant, alone[i], together[i]));
            if (Micrometers(feature, i, features[i].LargestMm, u) is { } micrometers)
            {
                refusals.Add(micrometers);
            }

            refusals.AddRange(
                points[i].Where(p => !(p.Displacement.Length <= job.Compensation.LimitMm)).Select(
                    p => Implausible(feature.Name, p, job.Compensation.LimitMm)));
        }

        return new(features, refusals) { Rule = job.Rule };
    }

    // The refusal of limits that are probably micrometers, or null. A deviation below half a program increment does not test the limits
    // either.
    private static Refusal? Micrometers(JobFeature feature, int index, double largest, double u)
    {
        var (band, off) = (feature.Tolerance.Band, Math.Abs(largest));
        var limit = Math.Abs(band.LowerMm) > Math.Abs(band.UpperMm) ? band.LowerMm : band.UpperMm;
        var nothing = Math.Max(UncertaintyBudget.CoverageFactor * u, 0.0005);
        return Math.Abs(limit) <= UsualTolerance || off <= nothing || Math.Abs(limit) <= MostTolerance * off
            ? null
            : RefusalForms.Refusal(
                RefusalForms.LimitImplausible,
                new()
                {
                    Feature = feature.Name,
                    Line = feature.Tolerance.Place?.Line,
                    Column = feature.Tolerance.Place?.Column,
                    Path = string.Create(CultureInfo.InvariantCulture, $"$.features[{index}].toleranceMm"),
                },
                feature.Name,
                limit,
                off,
                limit / 1000);
    }

    private static FeatureDecision Decide(
        JobFeature feature,
        ToleranceBand acceptance,
        IReadOnlyList<BoundaryPoint> points,
        JobCompensation compensation,
        double u,
        double significant,
        bool isAlone,
        bool isTogether)
    {
        var outside = points.Where(p => !acceptance.Contains(p.DecidedMm)).ToArray();
        var decision = outside.Length == 0 ? Decision.WithinTolerance
            : isAlone || isTogether ? Decision.Compensated
            : Decision.NotSignificant;
        return new(feature.Name, decision, points.Select(p => p.DecidedMm).MaxBy(Math.Abs), u, [.. points.Select(Decided)])
        {
            Acceptance = acceptance,
            SignificantMm = significant,
            IsSignificantTogether = decision == Decision.Compensated && !isAlone,
        };

        PointDecision Decided(BoundaryPoint point)
        {
            var (correction, share) = decision == Decision.Compensated ? Correction(point, acceptance, compensation) : default;
            return new(point, acceptance.ExcessOf(point.DecidedMm), correction)
            {
                Share = share,
                BaseShare = feature.CorrectsBase ? share : 0,
                ProbabilityBefore = Conformance.Probability(feature.Tolerance.Band, point.DecidedMm, u),
            };
        }
    }

    // The excess is the same share of the vector as of its normal component.
    private static (Vector2 Correction, double Share) Correction(BoundaryPoint point, ToleranceBand band, JobCompensation compensation)
    {
        var (followed, isWhole) = (point.FollowedMm, compensation.Amount == CompensationAmount.Whole);
        var amount = isWhole ? followed : band.ExcessOf(followed);
        var share = compensation.Gain * (isWhole ? 1 : followed == 0 ? 0 : amount / followed);
        return compensation.Along == CompensationDirection.Normal
            ? (point.Normal * (compensation.Gain * amount), share)
            : ((point.Displacement - (point.Normal * point.IgnoredMm)) * share, share);
    }

    private static Refusal Implausible(string feature, BoundaryPoint point, double limit) => RefusalForms.Refusal(
        RefusalForms.ImplausibleDeviation,
        new() { Feature = feature, Point = point.Label },
        point.Label,
        feature,
        point.Displacement.Length,
        limit);
}
