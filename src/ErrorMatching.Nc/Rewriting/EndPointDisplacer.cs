using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves the end points of named motions by a vector, including rapids and plunges. The motion before stays, unless the first
/// is a vertical arc: then the way to it moves along. After the last, moves along the tool axis and vertical arcs keep the moved place, and
/// the first motion in the plane ends where it did. If each end has its own vector, no other end moves.</summary>
internal static class EndPointDisplacer
{
    public static Outcome<PathChange> Run(NcPath path, DisplacementWish wish)
    {
        var change = new PathChange(path);
        for (var i = 0; i < wish.EndPoints.Count; i++)
        {
            // A helix to an angle moves as a whole, without a word of its own.
            if (!path.Motions[wish.EndPoints[i]].IsHelixToAngle && Obstacles.Of(path, wish.EndPoints[i]) is { } refusal)
            {
                return refusal;
            }

            if (Positioning.Only(path.Motions[wish.EndPoints[i]].UnknownEnd, wish.ByOf(i)) != Vector3.Zero)
            {
                return Obstacles.UnknownPlace(path, wish.EndPoints[i]);
            }

            change.Move(wish.EndPoints[i] + 1, wish.ByOf(i));
        }

        if (wish.IsPointByPoint)
        {
            return ArcThatMoves(change) is { } arc ? arc : change;
        }

        var named = new MotionRuns();
        foreach (var motion in wish.EndPoints)
        {
            named.Add(motion);
        }

        foreach (var motion in wish.EndPoints)
        {
            // A vertical arc keeps its form, so its start moves along.
            if (((path.Motions.IsLeadArc(motion) && !change.IsSet(motion)
                ? Positioning.CarryBack(change, motion + 1, named.Contains) : null)
                ?? Positioning.CarryAhead(change, motion + 1, named.Contains)) is { } refusal)
            {
                return refusal;
            }
        }

        return FollowWithArcs(change) is { } bad ? bad : change;
    }

    private static Refusal? ArcThatMoves(PathChange change)
    {
        var path = change.Path;
        foreach (var i in change.Affected())
        {
            if (path.Motions.IsArc(i) && (change.MoveOf(i) != Vector3.Zero || change.MoveOf(i + 1) != Vector3.Zero))
            {
                return BlockRefusal.At(
                    path.Program,
                    path.Motions[i].Block,
                    NcRefusalCodes.ArcForm,
                    "an arc cannot follow points that are displaced each by its own vector. Post it as short straight lines.");
            }
        }

        return null;
    }

    private static Refusal? FollowWithArcs(PathChange change)
    {
        var motions = change.Path.Motions;
        foreach (var i in change.Affected())
        {
            if (motions.IsArc(i) && change.FollowWithArc(i) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }
}
