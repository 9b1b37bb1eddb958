using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Checks the joints of the path: joint i is the start of motion i and the end of motion i - 1. Distances from wished lines and
/// circles do not show how far an end moved along them. So something else must fix each joint of a named element too.</summary>
internal sealed class JointCheck(ProofTask task, ProofFindings findings, WayCheck ways, ClosedContours closures, FilletCheck fillets)
{
    /// <summary>Sine of the angle below which two elements are tangent, so that one does not fix the end of the other.</summary>
    private const double TangentSine = 0.099;

    /// <summary>Sine of the smallest angle at which two elements with different displacements fix each other's ends.</summary>
    private const double SmallestCornerSine = 0.0089;

    /// <summary>Displacements that differ by no more count as equal, in increments.</summary>
    private const double TangentStep = 0.4;

    /// <summary>Joints that may move: those of named motions, those inside a fillet between named motions, those that positioning shares
    /// with them, and the other end of a closed contour.</summary>
    public bool[] Allowed()
    {
        var allowed = new bool[task.Before.Motions.Length + 1];
        for (var run = 0; run < task.Elements.Count; run++)
        {
            for (var joint = task.Elements[run].First; joint <= task.Elements[run].Last + 1; joint++)
            {
                allowed[joint] = true;
            }
        }

        for (var run = 1; run < task.Elements.Count; run++)
        {
            var (first, end) = (task.Elements[run - 1].Last + 1, task.Elements[run].First);
            if (fillets.IsWhole(first, end - 1))
            {
                allowed.AsSpan()[first..end].Fill(true);
            }
        }

        foreach (var motion in task.Wish.EndPoints)
        {
            allowed[motion + 1] = true;
        }

        foreach (var joint in closures.Joints)
        {
            allowed[joint] = true;
        }

        ways.AllowPositioning(allowed);
        return allowed;
    }

    /// <summary>Checks one end of a named element. It moved by its wish, or it is on the line or circle of another motion that meets the
    /// element there at an angle, or it is the tangent point of a fillet.</summary>
    public void Check(in NcMotion was, int motion, int joint, Vector2 wished)
    {
        var plane = was.Plane;
        var move = MoveOf(joint);
        var moved = plane.Project(default(Point3) + move) - Point2.Origin;
        if (Math.Abs(plane.Height(default(Point3) + move)) > 1e-9)
        {
            findings.Fail(was.Block, "an end moved along the tool axis.");
        }

        var other = closures.OtherEnd(joint);
        if (other >= 0 && (MoveOf(other) - move).Length > 1e-9)
        {
            findings.Fail(was.Block, "the contour no longer closes.");
        }

        if ((moved - wished).Length <= task.Increment + 1e-6 || fillets.Is(motion))
        {
            return;
        }

        var isHeld = false;
        foreach (var (candidate, atStart) in MotionsAt(joint).Concat(MotionsAt(other)))
        {
            isHeld |= candidate != motion && Holds(candidate, atStart, motion, joint, moved, wished);
        }

        if (!isHeld)
        {
            findings.Fail(
                was.Block,
                FormattableString.Invariant(
                    $"an end moved by ({moved.X:0.000}, {moved.Y:0.000}), where neither the wish nor a neighbor puts it."));
        }
    }

    // The cuts that meet at a joint, skipping pieces that shrank to it.
    private IEnumerable<(int Motion, bool AtStart)> MotionsAt(int joint)
    {
        var behind = joint;
        while (behind >= 0 && behind < task.Before.Motions.Length
            && (task.IsShrunk(behind, task.Before.Motions[behind]) || ways.IsPassed(behind)))
        {
            behind++;
        }

        if (behind >= 0 && behind < task.Before.Motions.Length && task.Before.Motions[behind] is { IsCut: true, MovesInPlane: true })
        {
            yield return (behind, true);
        }

        var ahead = joint - 1;
        while (ahead >= 0 && (task.IsShrunk(ahead, task.Before.Motions[ahead]) || ways.IsPassed(ahead)))
        {
            ahead--;
        }

        if (ahead >= 0 && task.Before.Motions[ahead] is { IsCut: true, MovesInPlane: true })
        {
            yield return (ahead, false);
        }
    }

    private bool Holds(int neighbor, bool atStart, int motion, int joint, Vector2 moved, Vector2 wished)
    {
        var (n, e) = (task.Before.Motions[neighbor], task.Before.Motions[motion]);
        if (n.Plane != e.Plane || ProofTask.Same(n.PlaneStart, n.PlaneEnd) && !n.IsArc)
        {
            return false;
        }

        var elementStarts = joint == motion;
        var (tangent, other) = (e.TangentAt(elementStarts ? 0 : 1), n.TangentAt(atStart ? 0 : 1));
        var isTangent = Math.Abs(tangent.Cross(other)) < TangentSine;
        if (task.Elements.IndexOf(neighbor) is >= 0 and var index)
        {
            var element = task.Wish.Elements[index];

            // The neighbor is measured as well. Two tangent elements meet on their common normal.
            var (leaving, arriving) = (elementStarts ? tangent : -tangent, atStart ? -other : other);
            var isReversal = leaving.Dot(arriving) < 0;
            var otherWished = atStart ? element.Start : element.End;
            var step = Math.Abs(wished.Dot(leaving.Left) - otherWished.Dot(arriving.Left));
            var meets = step > TangentStep * task.Increment && Math.Abs(tangent.Cross(other)) > SmallestCornerSine;
            return !isTangent || isReversal || meets || fillets.Is(neighbor)
                || IsOnCommonNormal(leaving, arriving, moved, wished, otherWished);
        }

        if (fillets.Is(neighbor))
        {
            return true;
        }

        var place = (elementStarts ? e.PlaneStart : e.PlaneEnd) + moved;
        return !isTangent && (n.IsArc
            ? Math.Abs(n.Arc.Circle.SignedDistance(place)) <= task.ArcTolerance + ProofTask.Mismatch(n)
            : Math.Abs(n.Segment.Line.SignedDistance(place)) <= task.LineTolerance);
    }

    private bool IsOnCommonNormal(Vector2 tangent, Vector2 other, Vector2 moved, Vector2 wished, Vector2 otherWished)
    {
        var along = (tangent + other).Normalize();
        var allowed = (TangentSine * wished.Length) + task.Increment + 1e-6;
        return Math.Abs(moved.Dot(along)) <= allowed || Math.Abs((moved - ((wished + otherWished) / 2)).Dot(along)) <= allowed;
    }

    private Point3 WasAt(int joint) => PlaceOf(task.Before.Motions, joint);

    private Vector3 MoveOf(int joint) => PlaceOf(task.After.Motions, joint) - WasAt(joint);

    // Behind something that the program does not determine, a motion begins elsewhere; the joint is where the one before it ends.
    private static Point3 PlaceOf(NcMotions motions, int joint) =>
        joint < motions.Length && (joint == 0 || motions[joint].UnknownStart == AxisSet.None)
            ? motions.StartOf(joint)
            : motions.EndOf(joint - 1);
}
