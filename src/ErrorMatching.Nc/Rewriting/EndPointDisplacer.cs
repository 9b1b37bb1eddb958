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

        return Centers(change) is { } bad ? bad : change;
    }

    private static void Retract(PathChange change, int joint, Vector3 by)
    {
        var motions = change.Path.Motions;
        for (; joint < motions.Length && !change.IsSet(joint + 1) && motions[joint] is { MovesInPlane: false, IsArc: false, Kind: not MotionKind.Reference }; joint++)
        {
            var plane = motions[joint].Plane;
            change.Move(joint + 1, plane.Lift(plane.Project(default(Point3) + by), 0) - default(Point3));
        }
    }

    private static NcRefusal? Centers(PathChange change)
    {
        var motions = change.Path.Motions;
        for (var i = 0; i < motions.Length; i++)
        {
            var motion = motions[i];
            if (!motion.IsArc || !(change.IsSet(i) || change.IsSet(i + 1)))
            {
                continue;
            }

            var (start, end) = (change.PlaneMoveOf(i, motion.Plane), change.PlaneMoveOf(i + 1, motion.Plane));
            if ((start - end).Length < 1e-12)
            {
                change.SetCenter(i, motion.Center + start);
                continue;
            }

            if (Obstacles.Of(change.Path, i) is { } obstacle)
            {
                return obstacle;
            }

            var wish = new ElementWish(i, start, (start + end) / 2, end);
            if (Carrier.Displaced(motion, wish)?.Circle is not { } circle)
            {
                return NcRefusal.At(change.Path.Program, motion.Block, NcRefusalCodes.ElementFlips, "this arc cannot follow the end that moves.");
            }

            change.SetCenter(i, circle.Center);
        }

        return null;
    }
}
