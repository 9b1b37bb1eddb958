using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Decides how each feature is compensated (Wang 2021, section 2.4): not at all inside the tolerance, by the whole deviation or
/// its excess outside. Implausible deviations refuse the job.</summary>
/// <remarks>
/// <para>A feature is outside its tolerance if the normal deviation of any of its points is. All its points are then compensated, because
/// moving only part of a line would bend it.</para>
/// <para>The deviation must also be significant: the feature's largest normal deviation must exceed <see cref="CoverageFactor"/> times
/// the combined standard uncertainty u of a normal deviation. Feed-forward compares a measured point with an exact one, so u is the
/// gauge's. Feedback compares two measured points, so u is the gauge's times the square root of 2.</para>
/// <para>Limits that are wider than <see cref="UsualTolerance"/> and more than <see cref="MostTolerance"/> times a significant deviation
/// of the feature are refused, because they are probably micrometers entered as millimeters. A tolerance may well be wider than the
/// deviations of a good piece: by a factor of 50 if 0.05 mm are allowed and 1 um is found. Micrometers read as millimeters are off by a
/// factor of 1000. Deviations that are not significant are not compensated and do not test the limits.</para>
/// <para>A displacement is plausible up to the job's limit, in any direction. A larger one at any point refuses the job.</para>
/// </remarks>
internal static class Decider
{
    /// <summary>Code of the refusal of a deviation beyond the job's limit.</summary>
    public const string ImplausibleDeviation = "implausible-deviation";

    /// <summary>Coverage factor k of the expanded uncertainty: 2, about 95 % of normally distributed errors.</summary>
    public const double CoverageFactor = 2;

    /// <summary>Largest ratio of a limit to the feature's deviation that is accepted without question.</summary>
    public const double MostTolerance = 100;

    /// <summary>Limits up to this value, mm, are usual; as micrometers they would be finer than any cut.</summary>
    public const double UsualTolerance = 1;

    /// <summary>Decides on all features of a job.</summary>
    /// <param name="job">The job, with features, tolerances, uncertainty and compensation.</param>
    /// <param name="points">For each feature of the job, in its order, the key points in the order of cutting.</param>
    /// <exception cref="ArgumentException">The lists do not match the job's features and points.</exception>
    public static MatingDecision Decide(MatingJob job, IReadOnlyList<IReadOnlyList<BoundaryPoint>> points)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(points);
        var u = job.Gauge.Uncertainty.CombinedMm * (job.Compensation.From == CompensationSource.Counterpart ? Math.Sqrt(2) : 1);
        var features = new List<FeatureDecision>();
        var refusals = new List<Refusal>();
        for (var i = 0; i < job.Features.Count; i++)
        {
            var feature = job.Features[i];
            if (points.Count != job.Features.Count || !feature.Points.SequenceEqual(points[i].Select(p => p.Label)))
            {
                throw new ArgumentException(
                    $"Found other points than those of {feature.Name}; expected its key points in the order of cutting.", nameof(points));
            }

            features.Add(Decide(feature.Name, feature.Tolerance.Band, points[i], job.Compensation, u));
            if (Micrometers(feature, i, features[i].LargestMm, u) is { } micrometers)
            {
                refusals.Add(micrometers);
            }

            refusals.AddRange(
                points[i].Where(p => !(p.Displacement.Length <= job.Compensation.LimitMm)).Select(
                    p => Implausible(feature.Name, p, job.Compensation.LimitMm)));
        }

        return new(features, refusals);
    }

    // The refusal of limits that are probably micrometers, or null. A deviation below half a program increment does not test the limits
    // either.
    private static Refusal? Micrometers(JobFeature feature, int index, double largest, double u)
    {
        var (band, off) = (feature.Tolerance.Band, Math.Abs(largest));
        var limit = Math.Abs(band.LowerMm) > Math.Abs(band.UpperMm) ? band.LowerMm : band.UpperMm;
        var form = RefusalForms.LimitImplausible;
        var nothing = Math.Max(CoverageFactor * u, 0.0005);
        return Math.Abs(limit) <= UsualTolerance || off <= nothing || Math.Abs(limit) <= MostTolerance * off
            ? null
            : new(form.Name, form.With(feature.Name, limit, off, limit / 1000), new()
            {
                Feature = feature.Name,
                Line = feature.Tolerance.Place?.Line,
                Column = feature.Tolerance.Place?.Column,
                Path = string.Create(CultureInfo.InvariantCulture, $"$.features[{index}].toleranceMm"),
            });
    }

    private static FeatureDecision Decide(
        string name, ToleranceBand band, IReadOnlyList<BoundaryPoint> points, JobCompensation compensation, double u)
    {
        var largest = points.Select(p => p.NormalMm).MaxBy(Math.Abs);
        var decision = points.All(p => band.Contains(p.NormalMm)) ? Decision.WithinTolerance
            : Math.Abs(largest) <= CoverageFactor * u ? Decision.NotSignificant
            : Decision.Compensated;
        return new(
            name,
            decision,
            largest,
            u,
            [
                .. points.Select(p => new PointDecision(
                    p, band.ExcessOf(p.NormalMm), decision == Decision.Compensated ? Correction(p, band, compensation) : Vector2.Zero))]);
    }

    private static Vector2 Correction(BoundaryPoint point, ToleranceBand band, JobCompensation compensation)
    {
        var normal = point.NormalMm;
        var amount = compensation.Amount == CompensationAmount.Whole ? normal : band.ExcessOf(normal);
        if (compensation.Along == CompensationDirection.Normal)
        {
            return point.Normal * (compensation.Gain * amount);
        }

        // The excess is the same fraction of the vector as of its normal component.
        var share = compensation.Amount == CompensationAmount.Whole ? 1 : normal == 0 ? 0 : amount / normal;
        return point.Displacement * (compensation.Gain * share);
    }

    private static Refusal Implausible(string feature, BoundaryPoint point, double limit) => new(
        ImplausibleDeviation,
        RefusalForms.ImplausibleDeviation.With(point.Label, feature, point.Displacement.Length, limit),
        new() { Feature = feature, Point = point.Label });
}
