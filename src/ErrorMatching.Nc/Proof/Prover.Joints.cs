using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// The joints of the path: joint i is where motion i begins and motion i - 1 ends. Distances from wished lines and circles say nothing about how far an end
/// went along them, so every joint of a named element must be held by something else as well.
/// </content>
public sealed partial class Prover
{
    /// <summary>Sine of the angle below which two elements run into each other tangentially, so that one does not hold the other.</summary>
    private const double TangentSine = 0.099;

    /// <summary>Sine of the smallest angle at which two elements with different displacements hold each other.</summary>
    private const double SmallestCornerSine = 0.0089;

    /// <summary>Displacements that differ by no more are one, mm.</summary>
    private const double TangentStep = 0.0004;

    private Point3 WasAt(int joint) => PlaceOf(_before.Motions, joint);

    private Vector3 MoveOf(int joint) => PlaceOf(_after.Motions, joint) - WasAt(joint);

    private static Point3 PlaceOf(NcMotions motions, int joint) => joint < motions.Length ? motions.StartOf(joint) : motions.EndOf(joint - 1);

    /// <summary>Joints that may move: those of named motions, those that positioning shares with them, and the other end of a closed contour.</summary>
    private bool[] AllowedJoints()
    {
        var allowed = new bool[_before.Motions.Length + 1];
        for (var run = 0; run < _elements.Count; run++)
        {
            for (var joint = _elements[run].First; joint <= _elements[run].Last + 1; joint++)
            {
                allowed[joint] = true;
            }
        }

        foreach (var motion in _wish.EndPoints)
        {
            allowed[motion + 1] = true;
        }

        foreach (var joint in _closures.Values)
        {
            allowed[joint] = true;
        }

        AllowPositioning(allowed);
        return allowed;
    }

    // Both ends of a contour that closes on itself are one corner of the piece: a later cut ends where a run begins, or an earlier one begins where a run ends.
    private void FindClosures()
    {
        var motions = _before.Motions;
        var contours = new ContourSearch(motions, SamePlace, _elements.Count, IsPassed);
        for (var run = 0; run < _elements.Count; run++)
        {
            var (first, last) = _elements[run];
            var (start, end) = (motions.StartOf(first), motions.EndOf(last));
            var closing = Same(motions.EndOf(first), start) ? first : contours.FirstEndingAt(start, first + 1, first);
            if (closing >= 0)
            {
                _closures[first] = closing + 1;
                _closures.TryAdd(closing + 1, first);
            }

            var opening = Same(motions.StartOf(last), end) ? last : contours.LastStartingAt(end, last - 1, last);
            if (opening >= 0)
            {
                _closures[last + 1] = opening;
                _closures.TryAdd(opening, last + 1);
            }

            foreach (var (begin, close) in Rings.Inside(motions, first, last))
            {
                (_closures[begin], _closures[close]) = (close, begin);
            }
        }
    }

    // What is set or called where the tool stands must find it where it was.
    private void CheckPlaceDependents()
    {
        foreach (var (block, joint) in _before.PlaceDependents)
        {
            // What follows may count from a new origin, so the end before it is compared.
            var motion = joint - 1;
            if (motion >= 0 && !Same(_before.Motions[motion].End, _after.Motions[motion].End))
            {
                Fail(block, "an origin is set or a program is called here at a place that moved.");
            }
        }
    }

    /// <summary>
    /// One end of a named element: it took the wish itself, or it lies on the line or circle of another motion that meets the element there at an angle, or it is
    /// the tangent point of a fillet.
    /// </summary>
    private void CheckJoint(in NcMotion was, int motion, int joint, Vector2 wished)
    {
        var plane = was.Plane;
        var move = MoveOf(joint);
        var moved = plane.Project(default(Point3) + move) - Point2.Origin;
        if (Math.Abs(plane.Height(default(Point3) + move)) > 1e-9)
        {
            Fail(was.Block, "an end moved along the tool axis.");
        }

        var other = _closures.TryGetValue(joint, out var closing) ? closing : -1;
        if (other >= 0 && (MoveOf(other) - move).Length > 1e-9)
        {
            Fail(was.Block, "the contour no longer closes.");
        }

        if ((moved - wished).Length <= _increment + 1e-6 || IsFillet(motion))
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
            Fail(was.Block, FormattableString.Invariant($"an end moved by ({moved.X:0.000}, {moved.Y:0.000}), where neither the wish nor a neighbor puts it."));
        }
    }

    // The cuts that meet at a joint; pieces that shrank to it are passed over.
    private IEnumerable<(int Motion, bool AtStart)> MotionsAt(int joint)
    {
        var behind = joint;
        while (behind >= 0 && behind < _before.Motions.Length && (IsShrunk(behind, _before.Motions[behind]) || IsPassed(behind)))
        {
            behind++;
        }

        if (behind >= 0 && behind < _before.Motions.Length && _before.Motions[behind] is { IsCut: true, MovesInPlane: true })
        {
            yield return (behind, true);
        }

        var ahead = joint - 1;
        while (ahead >= 0 && (IsShrunk(ahead, _before.Motions[ahead]) || IsPassed(ahead)))
        {
            ahead--;
        }

        if (ahead >= 0 && _before.Motions[ahead] is { IsCut: true, MovesInPlane: true })
        {
            yield return (ahead, false);
        }
    }

    /// <summary>True for a named line that was cut off by the displacement of a corner and shrank to it: what it was measured by are the elements on both sides.</summary>
    private bool IsShrunk(int motion, in NcMotion was) => !_after.Motions.MovesInPlane(motion) && _elements.Contains(motion) && was is { Kind: MotionKind.Line, MovesInPlane: true } && was.PlaneLength <= _reach;

    private bool Holds(int neighbor, bool atStart, int motion, int joint, Vector2 moved, Vector2 wished)
    {
        var (n, e) = (_before.Motions[neighbor], _before.Motions[motion]);
        if (n.Plane != e.Plane || Same(n.PlaneStart, n.PlaneEnd) && !n.IsArc)
        {
            return false;
        }

        var elementStarts = joint == motion;
        var (tangent, other) = (e.TangentAt(elementStarts ? 0 : 1), n.TangentAt(atStart ? 0 : 1));
        var isTangent = Math.Abs(tangent.Cross(other)) < TangentSine;
        if (_elements.IndexOf(neighbor) is >= 0 and var index)
        {
            var element = _wish.Elements[index];

            // It is measured itself; two that run into each other meet where their common normal says.
            var (leaving, arriving) = (elementStarts ? tangent : -tangent, atStart ? -other : other);
            var isReversal = leaving.Dot(arriving) < 0;
            var otherWished = atStart ? element.Start : element.End;
            var step = Math.Abs(wished.Dot(leaving.Left) - otherWished.Dot(arriving.Left));
            var meets = step > TangentStep && Math.Abs(tangent.Cross(other)) > SmallestCornerSine;
            return !isTangent || isReversal || meets || IsFillet(neighbor) || IsOnCommonNormal(leaving, arriving, moved, wished, otherWished);
        }

        if (IsFillet(neighbor))
        {
            return true;
        }

        var place = (elementStarts ? e.PlaneStart : e.PlaneEnd) + moved;
        return !isTangent && (n.IsArc ? Math.Abs(n.Arc.Circle.SignedDistance(place)) <= ArcTolerance + Mismatch(n) : Math.Abs(n.Segment.Line.SignedDistance(place)) <= LineTolerance);
    }

    private bool IsOnCommonNormal(Vector2 tangent, Vector2 other, Vector2 moved, Vector2 wished, Vector2 otherWished)
    {
        var along = (tangent + other).Normalize();
        var allowed = (TangentSine * wished.Length) + _increment + 1e-6;
        return Math.Abs(moved.Dot(along)) <= allowed || Math.Abs((moved - ((wished + otherWished) / 2)).Dot(along)) <= allowed;
    }

    /// <summary>True for an arc that joins two named lines tangentially and must go on doing so: one that was not named, or that was named as a fillet.</summary>
    private bool IsFillet(int motion) => (_elements.IndexOf(motion) is var element && (element < 0 || _wish.Elements[element].IsFillet))
        && Fillet.Around(_before, motion) is var (first, last) && Flank(first - 1) is not null && Flank(last + 1) is not null;
}
