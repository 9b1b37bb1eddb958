using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Where displaced elements meet. Changes nothing, so two threads can use it.</summary>
internal sealed class ElementJoints(DisplacedElements elements)
{
    /// <summary>Sine of the angle below which two elements count as tangent: 5.7 degrees.</summary>
    public const double TangentSine = 0.1;

    /// <summary>Sine of the angle below which the curvature of its elements does not affect a joint.</summary>
    private const double RoundSine = 0.001;

    /// <summary>Largest difference of the displacements of two elements that meet tangentially, in least increments: less than
    /// half.</summary>
    private const double TangentStep = 0.4;

    /// <summary>Sine of the smallest angle at which two elements with different displacements count as meeting: half a degree.</summary>
    private const double SmallestCornerSine = 0.009;

    /// <summary>An intersection further from the joint than this multiple of the displacement is not nearby.</summary>
    private const double Nearby = 12;

    private readonly NcPath _path = elements.Path;

    /// <summary>True if one element continues tangentially into the other.</summary>
    public static bool IsTangent(Vector2 before, Vector2 behind) => Math.Abs(before.Cross(behind)) < TangentSine && before.Dot(behind) > 0;

    /// <summary>True if an intersection is near the joint of elements that are displaced by an amount.</summary>
    public static bool IsNear(Point2 point, Point2 joint, double amount) => point.DistanceTo(joint) <= (Nearby * amount) + 1e-6;

    /// <summary>The displacement with the given components along two normals.</summary>
    public static Vector2 CornerMove(Vector2 normalA, double a, Vector2 normalB, double b) =>
        ((normalB.Left * -a) + (normalA.Left * b)) / normalA.Cross(normalB);

    /// <summary>The displacement of a joint on which both elements agree: a vertex of a polyline, or a tangential transition. Null at a
    /// corner.</summary>
    public Vector2? Smooth(int before, int behind)
    {
        var (moveA, moveB) = (elements.WishOf(before).End, elements.WishOf(behind).Start);
        if ((moveA - moveB).Length <= 1e-9)
        {
            return moveA;
        }

        var (tangentA, tangentB) = (_path.Motions[before].TangentAt(1), _path.Motions[behind].TangentAt(0));
        var (left, right) = (moveA.Dot(tangentA.Left), moveB.Dot(tangentB.Left));
        if (!IsTangent(tangentA, tangentB) || Math.Abs(left - right) > TangentStep * elements.Increment)
        {
            return null;
        }

        var offset = (left + right) / 2;
        var move = (tangentA.Left + tangentB.Left) * (offset / (1 + tangentA.Dot(tangentB)));
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        return Math.Abs(tangentA.Cross(tangentB)) > RoundSine && (a.IsArc || b.IsArc)
            ? RoundMove(before, behind, tangentA.Left * offset, tangentB.Left * offset, move)
            : move;
    }

    /// <summary>Where two displaced elements meet near a joint; null if they do not.</summary>
    public Point2? Meet(int before, int behind, int joint, double amount)
    {
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        var (tangentA, tangentB) = (a.TangentAt(1), b.TangentAt(0));
        if (Math.Abs(tangentA.Cross(tangentB)) < SmallestCornerSine)
        {
            return null;
        }

        var place = _path.Motions[joint].PlaneStart;
        var (moveA, moveB) = (elements.WishOf(before).End, elements.WishOf(behind).Start);
        var guess = a.PlaneEnd == b.PlaneStart
            ? place + CornerMove(tangentA.Left, moveA.Dot(tangentA.Left), tangentB.Left, moveB.Dot(tangentB.Left))
            : place;
        return elements.CarrierOf(before).Meet(elements.CarrierOf(behind), guess) is { } point && IsNear(point, place, amount)
            ? point
            : null;
    }

    /// <summary>True if two elements of which short pieces were cut off go on almost straight, are displaced alike, and meet further along
    /// than rounding explains.</summary>
    public bool IsVague(int before, int behind, Point2 point)
    {
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        var (tangentA, tangentB) = (a.TangentAt(1), b.TangentAt(0));
        var (moveA, moveB) = (elements.WishOf(before).End, elements.WishOf(behind).Start);
        if (!IsTangent(tangentA, tangentB)
            || Math.Abs(moveA.Dot(tangentA.Left) - moveB.Dot(tangentB.Left)) > TangentStep * elements.Increment)
        {
            return false;
        }

        var along = (tangentA + tangentB).Normalize();
        return IsFar(point - a.PlaneEnd, moveA) || IsFar(point - b.PlaneStart, moveB);

        bool IsFar(Vector2 moved, Vector2 wished) =>
            Math.Abs(moved.Dot(along)) > (0.9 * TangentSine * wished.Length) + (elements.Increment / 2);
    }

    /// <summary>Why two displaced elements do not meet near their joint, and what helps.</summary>
    public string WhyApart(int before, int behind)
    {
        var (a, b) = (_path.Motions[before], _path.Motions[behind]);
        var (tangentA, tangentB) = (a.TangentAt(1), b.TangentAt(0));
        var (left, right) = (elements.WishOf(before).End.Dot(tangentA.Left), elements.WishOf(behind).Start.Dot(tangentB.Left));
        var (sine, cosine) = (tangentA.Cross(tangentB), tangentA.Dot(tangentB));
        if (Math.Abs(sine) < SmallestCornerSine && cosine < 0)
        {
            return "the two go there and back on one line, a reversal by 180 degrees. Left of travel is the other side on the way back, so "
                + "they move apart. Name only one of them, and the other follows.";
        }

        // An unnamed arc between two moving lines stays tangent to both: it is a corner, not a piece of one of them.
        var advice = IsTangent(tangentA, tangentB) && a.IsArc != b.IsArc
            ? $"Where the arc {elements.NameOf(a.IsArc ? before : behind)} rounds a corner, do not name it: it then stays tangent to both "
                + "of its neighbors. Else displace both alike."
            : "Displace both alike, or displace less.";
        if (Math.Abs(left - right) > TangentStep * elements.Increment)
        {
            var decimals = Math.Abs(left - right) >= 0.002 ? "0.000" : "0.000000";
            return string.Create(
                CultureInfo.InvariantCulture,
                $"the two are displaced by different amounts ({left.ToString(decimals, CultureInfo.InvariantCulture)} and "
                    + $"{right.ToString(decimals, CultureInfo.InvariantCulture)} mm). {advice}");
        }

        var degrees = Elementary.Atan2(Math.Abs(sine), cosine) * 180 / Math.PI;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"they turn by {degrees:0.0} degrees there, and the displaced ones come together "
                + $"only further away than {Nearby} times the displacement, or not at all. Displace less, or name one of the two.");
    }

    // If one element is round, the tangents at the old joint meet away from the new joint. So the concentric circles through the displaced
    // joint are intersected, not the displaced circles: the ends of an arc with rounded words miss its circle.
    private Vector2 RoundMove(int before, int behind, Vector2 moveA, Vector2 moveB, Vector2 guess)
    {
        var place = _path.Motions[before].PlaneEnd;
        var (a, b) = (elements.CarrierOf(before).Through(place + moveA), elements.CarrierOf(behind).Through(place + moveB));
        return a.Meet(b, place + guess) is { } point && (point - place - guess).Length < TangentSine * guess.Length ? point - place : guess;
    }
}
