using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Compares the tool of the job with the radius that the program itself gives for cutter compensation. If they differ, what is cut
/// lies beside the programmed contour.</summary>
internal static class RadiusCheck
{
    /// <summary>Radii that differ by less are the same, mm.</summary>
    private const double SameMm = 0.0005;

    /// <summary>The first motion of each feature that is cut with another radius than the tool's, and that radius, mm; a radius that only
    /// the machine knows is none.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted with the job's tool.</param>
    /// <param name="maps">The places of the key points.</param>
    public static IReadOnlyList<(int Motion, double RadiusMm)> Others(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps)
    {
        if (!CompensatedPath.Concerns(path))
        {
            return [];
        }

        var (radii, tool) = (ProgramRadii.Of(path), job.Counterpart.ToolDiameterMm / 2);
        return
        [
            .. maps.SelectMany(m => m.Passes).Select(p => p.First).Distinct()
                .Where(i => Math.Abs((radii[i] ?? tool) - tool) > SameMm)
                .Select(i => (i, radii[i]!.Value)),
        ];
    }
}
