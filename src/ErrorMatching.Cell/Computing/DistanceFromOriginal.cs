using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Cell;

/// <summary>How far the features of a repeatedly corrected program are from those of the original one, measured on the programs themselves:
/// between and next to the points, including rounding.</summary>
internal static class DistanceFromOriginal
{
    // An arc that moves off its center may have its largest distance anywhere along the way.
    private const int Places = 16;

    /// <summary>The largest distance in mm and its block; null if the two programs do not have the same motions, so that they cannot be
    /// compared.</summary>
    /// <param name="original">The original program.</param>
    /// <param name="now">The corrected one.</param>
    /// <param name="maps">The features on it.</param>
    public static (double Mm, int Block)? Largest(NcPath original, NcPath now, IReadOnlyList<FeatureMap> maps)
    {
        if (original.Refusal is not null || original.Motions.Length != now.Motions.Length)
        {
            return null;
        }

        var largest = (Mm: 0.0, Block: 0);
        foreach (var pass in maps.SelectMany(m => m.Passes))
        {
            for (var i = pass.First; i <= pass.Last; i++)
            {
                var (was, isNow) = (original.Motions[i], now.Motions[i]);
                if (was.Kind != isNow.Kind || was.Plane != isNow.Plane)
                {
                    return null;
                }

                // A motion without length has no side to be displaced to.
                if (was is { MovesInPlane: true, IsKnownInPlane: true } && Between(was, isNow) is var mm && !(mm <= largest.Mm))
                {
                    largest = (mm, isNow.Block);
                }
            }
        }

        return largest;
    }

    // Across the cut: a corner that slides along it does not displace the wall.
    private static double Between(NcMotion was, NcMotion now)
    {
        if (!was.IsArc)
        {
            var along = was.TangentAt(0);
            return Math.Max(Math.Abs(along.Cross(now.PlaneStart - was.PlaneStart)), Math.Abs(along.Cross(now.PlaneEnd - was.PlaneStart)));
        }

        var (circle, arc) = (was.Arc.Circle, now.Arc);
        return Enumerable.Range(0, Places + 1).Max(i => Math.Abs(arc.At((double)i / Places).DistanceTo(circle.Center) - circle.Radius));
    }
}
