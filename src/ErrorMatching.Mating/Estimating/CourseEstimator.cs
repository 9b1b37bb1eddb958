using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Estimates how far the whole boundary must move, between and beyond its key points too, from the corrections at these points:
/// a wish for each motion that cuts a compensated feature. Each feature is estimated on its own.</summary>
internal static class CourseEstimator
{
    /// <summary>Estimates the courses of all compensated features.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it, in the order of the job.</param>
    /// <param name="decision">The decisions on the features; at least one is compensated.</param>
    /// <param name="wish">The wish; complete only if nothing is refused.</param>
    /// <returns>Why a feature cannot follow its corrections, or null.</returns>
    public static Refusal? Estimate(
        MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, MatingDecision decision, out DisplacementWish wish)
    {
        var elements = new List<ElementWish>();
        wish = DisplacementWish.OfElements([]);
        foreach (var (map, decided) in maps.Zip(decision.Features).Where(m => m.Second.Decision == Decision.Compensated))
        {
            Vector2[] corrections = [.. decided.Points.Select(p => job.Counterpart.Frame.Apply(p.Correction))];
            foreach (var cut in map.Passes.Select(pass => Cut(job, path, pass, corrections)))
            {
                if (map.Feature.RefuseCut(cut) is { } cannotFollow)
                {
                    return cannotFollow;
                }

                elements.AddRange(map.Feature.Wishes(cut));
            }
        }

        wish = DisplacementWish.OfElements([.. elements.OrderBy(e => e.Motion)]);
        return BeyondLimit(job.Compensation, path, maps, wish);
    }

    private static FeatureCut Cut(MatingJob job, NcPath path, FeaturePass pass, Vector2[] corrections) => new(path, pass, corrections)
    {
        Along = job.Compensation.Along,
        UncertaintyMm = job.Gauge.Uncertainty.CombinedMm,
        ToolDiameterMm = job.Counterpart.ToolDiameterMm,
    };

    // The limit applies between and beyond the points too: a course that swings out there follows no measurement.
    private static Refusal? BeyondLimit(
        JobCompensation compensation, NcPath path, IReadOnlyList<FeatureMap> maps, DisplacementWish wish)
    {
        var limit = compensation.LimitMm * Math.Max(1, compensation.Gain);
        var worst = wish.Elements.MaxBy(Largest)!;
        if (Largest(worst) <= limit)
        {
            return null;
        }

        var block = path.Motions[worst.Motion].Block;
        var name = path.Program.NameOf(path.Program[block]);
        var feature = maps.First(m => m.Blocks.Contains(block)).Feature.Name;
        return RefusalForms.Refusal(
            RefusalForms.ImplausibleCourse,
            new() { Feature = feature, Block = name, Line = block + 1 },
            name,
            feature,
            Largest(worst),
            limit);

        static double Largest(ElementWish element) => Math.Max(element.Start.Length, Math.Max(element.Middle.Length, element.End.Length));
    }
}
