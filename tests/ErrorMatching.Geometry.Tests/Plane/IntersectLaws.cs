using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Plane;

/// <summary>Whatever is met lies on both elements, in the first one's order, and nothing is met twice or only one way round.</summary>
public class IntersectLaws
{
    // Crossings near a tangency are as uncertain as the root of the rounding error; everything else keeps 1e-9.
    private const double Slack = 2e-9;

    [Fact]
    public void Points_of_lines_lie_on_both() =>
        Draw.Law(
            Draw.Line.Two(),
            p => Holds(
                Intersect.Lines(p.Item1, p.Item2),
                q => Math.Abs(p.Item1.SignedDistance(q)),
                q => Math.Abs(p.Item2.SignedDistance(q)) * Math.Abs(p.Item1.Direction.Cross(p.Item2.Direction)),
                p.Item1.Along));

    [Fact]
    public void Points_of_segments_lie_on_both() =>
        Draw.Law(
            Draw.Segment.Two(),
            p => Holds(Intersect.Lines(p.Item1, p.Item2), p.Item1.DistanceTo, p.Item2.DistanceTo, p.Item1.NearestFraction));

    [Fact]
    public void Points_of_line_and_circle_lie_on_both() =>
        Draw.Law(
            Draw.Line.Zip(Draw.Circle),
            p => Holds(
                Intersect.LineCircle(p.Item1, p.Item2),
                q => Math.Abs(p.Item1.SignedDistance(q)),
                q => Math.Abs(p.Item2.SignedDistance(q)),
                p.Item1.Along));

    [Fact]
    public void Points_of_segment_and_arc_lie_on_both() =>
        Draw.Law(
            Draw.Segment.Zip(Draw.Arc),
            p => Holds(Intersect.LineCircle(p.Item1, p.Item2), p.Item1.DistanceTo, p.Item2.DistanceTo, p.Item1.NearestFraction));

    [Fact]
    public void Points_of_circles_lie_on_both() =>
        Draw.Law(
            Draw.Circle.Two(),
            p => Holds(
                Intersect.Circles(p.Item1, p.Item2),
                q => Math.Abs(p.Item1.SignedDistance(q)),
                q => Math.Abs(p.Item2.SignedDistance(q)),
                q => Turn(p.Item1, q)));

    [Fact]
    public void Points_of_arcs_lie_on_both() =>
        Draw.Law(
            Draw.Arc.Two(), p => Holds(Intersect.Circles(p.Item1, p.Item2), p.Item1.DistanceTo, p.Item2.DistanceTo, p.Item1.FractionOf));

    [Fact]
    public void Circles_meet_the_same_both_ways() =>
        Draw.Law(Draw.Circle.Two(), p =>
        {
            var (there, back) = (Intersect.Circles(p.Item1, p.Item2), Intersect.Circles(p.Item2, p.Item1));
            return there.Kind == back.Kind && there.Count == back.Count
                && (there.Count == 0 || there.First.DistanceTo(back.Nearest(there.First)!.Value) < 1e-6);
        });

    [Fact]
    public void Segments_meet_exactly_where_their_ends_lie_on_opposite_sides() =>
        Draw.Law(Draw.Segment.Two(), p =>
        {
            var (a, b) = p;
            if (a.Length < 1 || b.Length < 1)
            {
                return true;
            }

            double[] sides = [
                a.Line.SignedDistance(b.Start), a.Line.SignedDistance(b.End), b.Line.SignedDistance(a.Start), b.Line.SignedDistance(a.End)];
            return sides.Any(s => Math.Abs(s) < 1e-6)
                || (Intersect.Lines(a, b).Count == 1) == (sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0);
        });

    [Fact]
    public void Pieces_meet_where_their_carriers_do_if_the_point_is_on_both_pieces() =>
        Draw.Law(Draw.Arc.Two(), p =>
        {
            var (a, b) = p;
            var carriers = Intersect.Circles(a.Circle, b.Circle);
            var expected = carriers.Kind == IntersectionKind.Crossing
                ? ((Point2[])[carriers.First, carriers.Second]).Count(
                    q => a.FractionOf(q) is >= 0 and <= 1 && b.FractionOf(q) is >= 0 and <= 1)
                : carriers.Count;
            return carriers.Kind != IntersectionKind.Crossing
                || Intersect.Circles(a, b).Count == expected
                || NearAnEnd(carriers, a)
                || NearAnEnd(carriers, b);
        });

    private static bool NearAnEnd(Intersection2 met, Arc2 arc) =>
        met.Nearest(arc.Start)!.Value.DistanceTo(arc.Start) < 1e-6 || met.Nearest(arc.End)!.Value.DistanceTo(arc.End) < 1e-6;

    private static bool Holds(Intersection2 met, Func<Point2, double> toFirst, Func<Point2, double> toSecond, Func<Point2, double> along) =>
        (met.Count < 1 || (toFirst(met.First) <= Slack && toSecond(met.First) <= Slack))
        && (
            met.Count < 2
                || (
                    toFirst(met.Second) <= Slack
                        && toSecond(met.Second) <= Slack
                        && along(met.First) <= along(met.Second)
                        && met.First != met.Second));

    private static double Turn(Circle2 circle, Point2 point)
    {
        var turned = (point - circle.Center).Direction.Degrees;
        return turned < 0 ? turned + 360 : turned;
    }
}
