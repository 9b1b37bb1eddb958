using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Finds the inside corners of the boundary in which the tool leaves a round of its own radius, and no key point tells whether the
/// part has one: a part with a sharper corner does not go in there, whatever is corrected.</summary>
internal static class InsideCorners
{
    // Degrees: two motions that turn by less are one boundary.
    private const double Smooth = 1;

    /// <summary>The corners between motions that cut features, in the order of cutting, each once.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    public static IEnumerable<UncutCorner> Find(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps)
    {
        var cuts = new Dictionary<int, (FeatureMap Map, FeaturePass Pass)>();
        foreach (var map in maps)
        {
            foreach (var motion in FeaturePass.Moving(path, map.Passes[0].First, map.Passes[0].Last))
            {
                cuts.TryAdd(motion, (map, map.Passes[0]));
            }
        }

        foreach (var (motion, (map, pass)) in cuts.OrderBy(c => c.Key))
        {
            var next = motion + 1;
            while (next < path.Motions.Length && !path.Motions[next].MovesInPlane && path.Motions[next].Start == path.Motions[next].End)
            {
                next++;
            }

            if (!cuts.TryGetValue(next, out var other) || IsTold(pass, motion, atEnd: true) || IsTold(other.Pass, next, atEnd: false))
            {
                continue;
            }

            var (before, after) = (path.Motions[motion].TangentAt(1), path.Motions[next].TangentAt(0));
            var turn = Elementary.Atan2(before.Cross(after), before.Dot(after)) * 180 / Math.PI;
            if (Math.Abs(turn) < Smooth || turn > 0 == pass.Feet[0].MaterialIsLeft)
            {
                continue;
            }

            // From the point of a sharp corner to the round in it.
            var part = (1 / Elementary.Cos(turn * Math.PI / 360)) - 1;
            var radius = job.Counterpart.ToolDiameterMm / 2;
            var allowed = Math.Min(LimitOf(map.Feature), LimitOf(other.Map.Feature));
            if (radius * part > allowed)
            {
                yield return new(motion, next, radius, radius * part, 2 * allowed / part);
            }
        }
    }

    // A key point on the round says where the part's corner is.
    private static bool IsTold(FeaturePass pass, int motion, bool atEnd) =>
        pass.Feet.Any(f => f.OnCorner && f.Motion == motion && f.Fraction > 0.5 == atEnd);

    // Material that stands beyond the boundary is what the lower limit of the part's deviation speaks of.
    private static double LimitOf(JobFeature feature) => feature.Tolerance.Band.Opposite().UpperMm;
}

/// <summary>An inside corner that the tool leaves rounder than the limits of a sharp one allow.</summary>
/// <param name="Before">Position of the motion before it.</param>
/// <param name="After">Position of the motion after it.</param>
/// <param name="RadiusMm">Radius of the round.</param>
/// <param name="OverlapMm">By how much a part with a sharp corner would overlap there.</param>
/// <param name="MostDiameterMm">Diameter of the largest tool that the limits allow there.</param>
internal sealed record UncutCorner(int Before, int After, double RadiusMm, double OverlapMm, double MostDiameterMm);
