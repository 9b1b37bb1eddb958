using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Moves the end points of named motions by a vector: rapids and plunges too. The motion before stays; behind, what only moves along the tool axis keeps the
/// moved place, and the first motion in the plane ends where it did.
/// </summary>
internal static class EndPointDisplacer
{
    public static NcOutcome<PathChange> Run(NcPath path, DisplacementWish wish)
    {
        var change = new PathChange(path);
        foreach (var motion in wish.EndPoints)
        {
            if (Obstacles.Of(path, motion) is { } refusal)
            {
                return refusal;
            }

            change.Move(motion + 1, wish.By);
        }

        foreach (var motion in wish.EndPoints)
        {
            Retract(change, motion + 1, wish.By);
        }

        return FollowWithArcs(change) is { } bad ? bad : change;
    }

    private static void Retract(PathChange change, int joint, Vector3 by)
    {
        var motions = change.Path.Motions;
        for (; joint < motions.Length && !change.IsSet(joint + 1) && !motions[joint].MovesInPlane; joint++)
        {
            var plane = motions[joint].Plane;
            change.Move(joint + 1, plane.Lift(plane.Project(default(Point3) + by), 0) - default(Point3));
        }
    }

    private static NcRefusal? FollowWithArcs(PathChange change)
    {
        var motions = change.Path.Motions;
        foreach (var i in change.Affected())
        {
            if (motions[i].IsArc && change.FollowWithArc(i) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }
}
