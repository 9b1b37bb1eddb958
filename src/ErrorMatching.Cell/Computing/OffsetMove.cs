using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Cell;

/// <summary>How far offsets of the control displace the boundary that a program cuts.</summary>
internal static class OffsetMove
{
    // Along an arc, a turn may displace a place between its ends most.
    private const int Places = 16;

    /// <summary>The largest displacement: of every place of the features, the radius and the way of the place together.</summary>
    /// <param name="match">The match.</param>
    /// <param name="radiusMm">How far the boundary moves toward the tool, mm.</param>
    /// <param name="move">How the program moves in its own frame.</param>
    public static LargestMove Largest(MatchResult match, double radiusMm, RigidTransform2 move)
    {
        var largest = new LargestMove(0, "", null);
        foreach (var pass in match.Maps.SelectMany(m => m.Passes))
        {
            for (var i = pass.First; i <= pass.Last; i++)
            {
                var motion = match.Before.Motions[i];
                var steps = motion.IsArc ? Places : 1;
                for (var k = 0; motion.MovesInPlane && k <= steps; k++)
                {
                    var mm = Math.Abs(radiusMm) + WayOf(motion.PlaneAt((double)k / steps), move).Length;
                    if (mm > largest.Mm + 1e-12)
                    {
                        var name = match.Before.Program.NameOf(match.Before.Program[motion.Block]);
                        largest = new(mm, Recorded.AtBlock.With(name), name);
                    }
                }
            }
        }

        return largest;
    }

    /// <summary>The displacement at each key point, in the job's order.</summary>
    /// <param name="match">The match.</param>
    /// <param name="radiusMm">How far the boundary moves toward the tool, mm.</param>
    /// <param name="move">How the program moves in its own frame.</param>
    public static IReadOnlyList<PointCorrection> AtPoints(MatchResult match, double radiusMm, RigidTransform2 move) =>
    [
        .. match.Maps.SelectMany(m => m.Passes[0].Feet).Select(f =>
        {
            var by = (f.Normal * radiusMm) + WayOf(match.Before.Motions[f.Motion].PlaneAt(f.Fraction), move);
            return new PointCorrection(f.Label, by.X, by.Y, 0);
        }),
    ];

    private static Vector2 WayOf(Point2 place, RigidTransform2 move) => move.Apply(place) - place;
}
