using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// The ends of a run. The border joint is the intersection of the displaced element with its neighbor's own, undisplaced carrier: the neighbor's end slides
/// along itself. Where the neighbor is no plain cut, or does not meet the element nearby, the joint takes the displacement, and positioning follows.
/// A closed contour has its neighbor at its other end.
/// </content>
internal sealed partial class ElementDisplacer
{
    // Where a named motion closes the contour, both ends are set already.
    private int Unnamed(int motion) => motion >= 0 && _named.Contains(motion) ? -1 : motion;

    private void Borders(int first, int last, int closing, int opening)
    {
        Border(first, closing >= 0 ? closing : first - 1, first, atStart: true, closing >= 0 ? closing + 1 : -1);
        Border(last, opening >= 0 ? opening : last + 1, last + 1, atStart: false, opening);
    }

    /// <summary>Decides one border joint.</summary>
    /// <param name="element">The displaced element.</param>
    /// <param name="neighbor">The motion that it meets there.</param>
    /// <param name="joint">The joint of the element.</param>
    /// <param name="atStart">True if the joint is the element's start.</param>
    /// <param name="otherJoint">The joint of the neighbor where a closed contour makes that another one, else -1.</param>
    private void Border(int element, int neighbor, int joint, bool atStart, int otherJoint)
    {
        if (_change.IsSet(joint))
        {
            return;
        }

        var motion = _path.Motions[element];
        var wished = atStart ? WishOf(element).Start : WishOf(element).End;
        var slide = (uint)neighbor < (uint)_path.Motions.Length ? Slide(element, neighbor, atStart) : null;
        if (slide is { } meeting)
        {
            var place = atStart ? motion.PlaneStart : motion.PlaneEnd;
            Shrink(atStart ? joint : meeting.Element + 1, atStart ? meeting.Element : joint, meeting.Point);
            Place(joint, motion.Plane, meeting.Point - place);
            if (otherJoint >= 0 && !_change.IsSet(otherJoint))
            {
                Place(otherJoint, motion.Plane, meeting.Point - place);
            }

            return;
        }

        Place(joint, motion.Plane, wished);
        if (otherJoint >= 0 && !_change.IsSet(otherJoint))
        {
            Place(otherJoint, motion.Plane, wished);
        }
    }

    private void Place(int joint, CoordinatePlane plane, Vector2 move)
    {
        _change.Move(joint, plane, move);
        _change.CarryPositioning(joint);
    }

    /// <summary>Where a displaced element meets its neighbor's own carrier, and which element that is after short ones were cut off; null if the neighbor cannot slide.</summary>
    private (Point2 Point, int Element)? Slide(int element, int neighbor, bool atStart)
    {
        var (e, n) = (_path.Motions[element], _path.Motions[neighbor]);
        if (n is not { IsCut: true, MovesInPlane: true } || n.Plane != e.Plane || n.Frame != e.Frame || n.Has(MotionFlags.CompensationSwitches)
            || !n.IsKnownInPlane || Obstacles.Of(_path, neighbor) is not null)
        {
            return null;
        }

        var joint = atStart ? e.PlaneStart : e.PlaneEnd;
        var (tangent, other) = (e.TangentAt(atStart ? 0 : 1), n.TangentAt(atStart ? 1 : 0));
        if (Math.Abs(tangent.Cross(other)) < TangentSine)
        {
            return null;
        }

        var wished = atStart ? WishOf(element).Start : WishOf(element).End;
        var guess = joint + CornerMove(tangent.Left, wished.Dot(tangent.Left), other.Left, 0);
        while (CarrierOf(element).Meet(Carrier.Of(n), guess) is { } point && IsNear(point, joint, wished.Length) && point.DistanceTo(joint) < n.PlaneLength)
        {
            if (e.PlaneStart.DistanceTo(e.PlaneEnd) < 1e-9 && (point - joint - wished).Length > 1e-6)
            {
                // Both ends of a full circle are one place: an end that slid along an oblique lead-in would leave a gap or overrun the other.
                return null;
            }

            if (!EndsBefore(element, point, !atStart) || !_named.Contains(element + (atStart ? 1 : -1)))
            {
                return (point, element);
            }

            element += atStart ? 1 : -1;
        }

        return null;
    }
}
