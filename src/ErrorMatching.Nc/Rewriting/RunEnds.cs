using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Moves the ends of runs of displaced elements. The joint at an end is the intersection of the displaced element with its
/// neighbor's undisplaced carrier: the neighbor's end slides along itself. If the neighbor is not a plain cut, or does not meet the element
/// nearby, the joint moves by the displacement, and positioning follows. In a closed contour, the neighbor is at the other end.</summary>
internal sealed class RunEnds(DisplacedElements elements, PathChange change, ShortPieces pieces)
{
    /// <summary>Places closer than this are the same, mm.</summary>
    public const double SamePlace = 1e-6;

    private readonly NcPath _path = change.Path;

    // The joints at the ends of runs, in the order in which they were set.
    private readonly List<int> _borders = [];

    /// <summary>Moves both ends of a run.</summary>
    /// <param name="first">First motion of the run.</param>
    /// <param name="last">Last motion of the run.</param>
    /// <param name="closing">The cut that closes the contour at its start; -1 if there is none.</param>
    /// <param name="opening">The cut that closes the contour at its end; -1 if there is none.</param>
    /// <returns>The reason why one cannot move, or null.</returns>
    public Refusal? Move(int first, int last, int closing, int opening) =>
        Border(first, closing >= 0 ? closing : first - 1, first, atStart: true, closing >= 0 ? closing + 1 : -1)
            ?? Border(last, opening >= 0 ? opening : last + 1, last + 1, atStart: false, opening);

    // The contour closes at a joint that another element already set; it must fit this element too.
    private Refusal? Suit(int element, int neighbor, int joint, bool atStart, int otherJoint)
    {
        var plane = _path.Motions[element].Plane;
        var move = change.PlaneMoveOf(otherJoint, plane);
        if (!IsOnCarrier(element, atStart ? 0 : 1, move))
        {
            return DoesNotClose(element, neighbor);
        }

        Place(joint, plane, move);
        return null;
    }

    private Refusal DoesNotClose(int element, int neighbor) => elements.At(
        _path.Motions[element],
        NcRefusalCodes.NoIntersection,
        $"displaced as asked, the contour no longer closes with {elements.NameOf(neighbor)}.");

    /// <summary>Decides one border joint.</summary>
    /// <param name="element">The displaced element.</param>
    /// <param name="neighbor">The motion that meets it there.</param>
    /// <param name="joint">The joint of the element.</param>
    /// <param name="atStart">True if the joint is the element's start.</param>
    /// <param name="otherJoint">The neighbor's joint if a closed contour gives it another one; otherwise -1.</param>
    private Refusal? Border(int element, int neighbor, int joint, bool atStart, int otherJoint)
    {
        if (change.IsSet(joint))
        {
            return null;
        }

        if (otherJoint >= 0 && change.IsSet(otherJoint))
        {
            return Suit(element, neighbor, joint, atStart, otherJoint);
        }

        var motion = _path.Motions[element];
        var wished = atStart ? elements.WishOf(element).Start : elements.WishOf(element).End;
        var slide = (uint)neighbor < (uint)_path.Motions.Length ? Slide(element, neighbor, atStart) : null;
        if (slide is { } meeting)
        {
            pieces.Shrink(atStart ? joint : meeting.Element + 1, atStart ? meeting.Element : joint, meeting.Point);
        }

        var move = slide is { } met ? met.Point - (atStart ? motion.PlaneStart : motion.PlaneEnd) : wished;
        Place(joint, motion.Plane, move);
        if (otherJoint < 0)
        {
            return null;
        }

        // A third named element may begin or end there too.
        var third = atStart ? otherJoint : otherJoint - 1;
        if ((uint)third < (uint)_path.Motions.Length && elements.Contains(third) && !IsOnCarrier(third, atStart ? 0 : 1, move))
        {
            return DoesNotClose(element, third);
        }

        Place(otherJoint, motion.Plane, move);
        return null;
    }

    private bool ChangesTool(int joint) => _path.ChangesTool(joint, joint);

    private bool IsOnCarrier(int element, int fraction, Vector2 move)
    {
        var motion = _path.Motions[element];
        var place = (fraction == 0 ? motion.PlaneStart : motion.PlaneEnd) + move;
        return elements.CarrierOf(element).Distance(place) <= SamePlace;
    }

    /// <summary>Moves a joint at the end of a run.</summary>
    public void Place(int joint, CoordinatePlane plane, Vector2 move)
    {
        change.Move(joint, plane, move);
        _borders.Add(joint);
    }

    /// <summary>Moves positioning with the ends. Call it when all joints of named motions are set: positioning between two of them leads
    /// from one's place to the other's.</summary>
    /// <returns>The reason why it cannot move, or null.</returns>
    public Refusal? CarryPositioning()
    {
        foreach (var joint in _borders)
        {
            if ((Positioning.CarryAhead(change, joint, elements.Contains) ?? Positioning.CarryBack(change, joint, elements.Contains))
                is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    /// <summary>Where a displaced element meets its neighbor's carrier, and which element remains there after short ones were cut off;
    /// null if the neighbor cannot slide. Both ends of a full circle are one place: if one slid by itself, it would leave a gap or
    /// overlap, or by a last bit no circle at all.</summary>
    private (Point2 Point, int Element)? Slide(int element, int neighbor, bool atStart)
    {
        var (e, n) = (_path.Motions[element], _path.Motions[neighbor]);
        if (n is not { IsCut: true, MovesInPlane: true }
            || n.Plane != e.Plane
            || n.Frame != e.Frame
            || n.Has(MotionFlags.CompensationSwitches)
            || e.PlaneStart.DistanceTo(e.PlaneEnd) < 1e-9
            || !n.IsKnownInPlane || Obstacles.Of(_path, neighbor) is not null || ChangesTool(atStart ? element : element + 1))
        {
            return null;
        }

        var joint = atStart ? e.PlaneStart : e.PlaneEnd;
        var (tangent, other) = (e.TangentAt(atStart ? 0 : 1), n.TangentAt(atStart ? 1 : 0));
        if (Math.Abs(tangent.Cross(other)) < ElementJoints.TangentSine)
        {
            return null;
        }

        var wished = atStart ? elements.WishOf(element).Start : elements.WishOf(element).End;
        var guess = joint + ElementJoints.CornerMove(tangent.Left, wished.Dot(tangent.Left), other.Left, 0);

        // Rounding takes up to 1.4 increments of the neighbor; more must be left of it, or it would vanish or turn round.
        while (elements.CarrierOf(element).Meet(Carrier.Of(n), guess) is { } point
            && ElementJoints.IsNear(point, joint, wished.Length)
            && point.DistanceTo(joint) < n.PlaneLength - (2 * elements.Increment))
        {
            if (!pieces.EndsBefore(element, point, !atStart) || !elements.Contains(element + (atStart ? 1 : -1)))
            {
                return (point, element);
            }

            element += atStart ? 1 : -1;
            if (Math.Abs(_path.Motions[element].TangentAt(atStart ? 0 : 1).Cross(other)) < ElementJoints.TangentSine)
            {
                // What is left meets the neighbor so shallowly that it could end anywhere along it.
                return null;
            }
        }

        return null;
    }
}
