using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Two elements that meet at any angle, on the grid of a program: N10 arrives, N20 leaves. Where their offsets meet is worked out here by
/// the formulas for lines and circles, from the two elements as the program has them.
/// </summary>
internal sealed class ShallowJoint
{
    private static readonly Point2 Joint = new(12.3, -4.5);

    /// <summary>A joint.</summary>
    /// <param name="before">Radius of the element that arrives: 0 for a line, negative for a clockwise arc.</param>
    /// <param name="behind">The same of the element that leaves.</param>
    /// <param name="degrees">By how much the path turns to the left at the joint.</param>
    /// <param name="decimals">Decimals of the program.</param>
    public ShallowJoint(double before, double behind, double degrees, int decimals)
    {
        var heading = Angle.FromDegrees(37);
        var start = Along(before, heading, -1);
        var end = Along(behind, heading + Angle.FromDegrees(degrees), 1);
        var text = new System.Text.StringBuilder("G21 G17 G40 G90\n");
        var format = "0.0" + new string('#', decimals - 1);
        string Number(double value) => Math.Round(value, decimals).ToString(format, CultureInfo.InvariantCulture);
        string Block(double radius, Point2 from, Angle direction, Point2 arcStart, Point2 to)
        {
            var origin = new Vector2(Math.Round(from.X, decimals), Math.Round(from.Y, decimals));
            var center = arcStart + (Vector2.FromDirection(direction).Left * radius) - origin;
            var arc = radius == 0 ? "" : $" I{Number(center.X)} J{Number(center.Y)}";
            return $"{(radius == 0 ? "G1" : radius > 0 ? "G3" : "G2")} X{Number(to.X)} Y{Number(to.Y)}{arc} F100\n";
        }

        text.Append(CultureInfo.InvariantCulture, $"G0 X{Number(start.X)} Y{Number(start.Y)}\nG1 Z-1. F100\n");
        text.Append("N10 ").Append(Block(before, start, heading, Joint, Joint));
        text.Append("N20 ").Append(Block(behind, Joint, heading + Angle.FromDegrees(degrees), Joint, end));
        Text = text.Append("G0 Z5.\n").ToString();
    }

    public string Text { get; }

    /// <summary>Where the offsets of two motions meet, nearest to their joint; each circle is the one through the joint.</summary>
    public static Point2 Closed(NcMotion before, NcMotion behind, double left)
    {
        var joint = before.PlaneEnd;
        if (!before.IsArc && !behind.IsArc)
        {
            var (a, b) = (before.Segment.Line.Normal, behind.Segment.Line.Normal);
            return joint + ((a + b) * (left / (1 + a.Dot(b))));
        }

        if (before.IsArc && behind.IsArc)
        {
            var (p, q, r, s) = (before.Center, behind.Center, Radius(before, joint, left), Radius(behind, joint, left));
            var (axis, apart) = ((q - p).Normalize(), p.DistanceTo(q));
            var along = ((r * r) - (s * s) + (apart * apart)) / (2 * apart);
            var aside = Math.Sqrt(Math.Max(0, (r * r) - (along * along)));
            return Nearest(p + (axis * along) + (axis.Left * aside), p + (axis * along) - (axis.Left * aside), joint);
        }

        var (line, arc) = before.IsArc ? (behind, before) : (before, behind);
        var (normal, center, radius) = (line.Segment.Line.Normal, arc.Center, Radius(arc, joint, left));
        var distance = (center - joint).Dot(normal) - left;
        var (foot, half) = (center - (normal * distance), Math.Sqrt(Math.Max(0, (radius * radius) - (distance * distance))));
        return Nearest(foot + (normal.Left * half), foot - (normal.Left * half), joint);
    }

    /// <summary>How far a place is from a motion's offset.</summary>
    public static double Off(NcMotion motion, Point2 joint, Point2 place, double left) => motion.IsArc
        ? Math.Abs(place.DistanceTo(motion.Center) - Radius(motion, joint, left))
        : Math.Abs((place - joint).Dot(motion.Segment.Line.Normal) - left);

    private static double Radius(NcMotion arc, Point2 joint, double left) =>
        joint.DistanceTo(arc.Center) - (arc.Kind == MotionKind.ArcCounterClockwise ? left : -left);

    private static Point2 Nearest(Point2 a, Point2 b, Point2 to) => a.DistanceTo(to) <= b.DistanceTo(to) ? a : b;

    // 15 mm of a line or 50 degrees of a circle, ahead or back.
    private static Point2 Along(double radius, Angle heading, int sign)
    {
        var direction = Vector2.FromDirection(heading);
        if (radius == 0)
        {
            return Joint + (direction * (15 * sign));
        }

        var center = Joint + (direction.Left * radius);
        var turned = (Joint - center).Direction + Angle.FromDegrees(radius > 0 ? 50 * sign : -50 * sign);
        return center + (Vector2.FromDirection(turned) * Math.Abs(radius));
    }
}
