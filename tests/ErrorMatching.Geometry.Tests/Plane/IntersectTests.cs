namespace ErrorMatching.Geometry.Tests.Plane;

public class IntersectTests
{
    private static readonly Line2 XAxis = new(new(0, 0), new(1, 0));

    [Fact]
    public void Lines_cross_in_one_point()
    {
        var met = Intersect.Lines(XAxis, Line2.Through(new(3, -4), new(3, 7)));
        Assert.Equal((IntersectionKind.Crossing, 1, new Point2(3, 0)), (met.Kind, met.Count, met.First));
    }

    [Fact]
    public void Parallel_lines_are_said_to_be_parallel() =>
        Assert.Equal(Intersection2.Nowhere(IntersectionKind.Parallel), Intersect.Lines(XAxis, new Line2(new(0, 1), new(-1, 0))));

    [Fact]
    public void One_line_twice_is_coincident_without_ends() =>
        Assert.Equal(Intersection2.Nowhere(IntersectionKind.Coincident), Intersect.Lines(XAxis, new Line2(new(5, 0), new(-1, 0))));

    [Fact]
    public void Line_and_segment_on_it_share_the_segment_in_the_order_of_the_first()
    {
        var segment = new Segment2(new(4, 0), new(1, 0));
        Assert.Equal(new Intersection2(IntersectionKind.Coincident, new(1, 0), new(4, 0), 2), Intersect.Lines(XAxis, segment));
        Assert.Equal(new Intersection2(IntersectionKind.Coincident, new(4, 0), new(1, 0), 2), Intersect.Lines(segment, XAxis));
    }

    [Fact]
    public void Segment_that_stops_before_a_line_does_not_meet_it() =>
        Assert.Equal(Intersection2.Nowhere(IntersectionKind.None), Intersect.Lines(XAxis, new Segment2(new(2, 5), new(2, 0.001))));

    [Fact]
    public void Segment_that_ends_on_a_line_meets_it() =>
        Assert.Equal(
            new Intersection2(IntersectionKind.Crossing, new(2, 0), default, 1),
            Intersect.Lines(XAxis, new Segment2(new(2, 5), new(2, 0))));

    [Fact]
    public void Overlapping_segments_share_the_common_stretch() =>
        Assert.Equal(
            new Intersection2(IntersectionKind.Coincident, new(3, 0), new(5, 0), 2),
            Intersect.Lines(new Segment2(new(0, 0), new(5, 0)), new Segment2(new(9, 0), new(3, 0))));

    [Fact]
    public void Segments_end_to_end_touch_in_one_point() =>
        Assert.Equal(
            new Intersection2(IntersectionKind.Tangent, new(5, 0), default, 1),
            Intersect.Lines(new Segment2(new(0, 0), new(5, 0)), new Segment2(new(5, 0), new(9, 0))));

    [Fact]
    public void Segments_apart_on_one_line_do_not_meet() =>
        Assert.Equal(IntersectionKind.None, Intersect.Lines(new Segment2(new(0, 0), new(5, 0)), new Segment2(new(6, 0), new(9, 0))).Kind);

    [Fact]
    public void Segments_side_by_side_are_parallel() =>
        Assert.Equal(
            IntersectionKind.Parallel, Intersect.Lines(new Segment2(new(0, 0), new(5, 0)), new Segment2(new(0, 1), new(5, 1))).Kind);

    [Fact]
    public void Segments_whose_lines_cross_beyond_an_end_do_not_meet() =>
        Assert.Equal(IntersectionKind.None, Intersect.Lines(new Segment2(new(0, 0), new(5, 0)), new Segment2(new(6, -1), new(6, 1))).Kind);

    [Fact]
    public void Segment_without_length_is_met_as_a_point()
    {
        var place = new Segment2(new(2, 0), new(2, 0));
        Assert.Equal(new Intersection2(IntersectionKind.Crossing, new(2, 0), default, 1), Intersect.Lines(XAxis, place));
        Assert.Equal(IntersectionKind.None, Intersect.Lines(place, new Segment2(new(0, 1), new(1, 1))).Kind);
        Assert.Equal(1, Intersect.LineCircle(place, new Circle2(new(0, 0), 2)).Count);
        Assert.Equal(0, Intersect.LineCircle(place, new Arc2(new(0, 0), 2, Angle.FromDegrees(90), Angle.FromDegrees(90))).Count);
    }

    [Fact]
    public void Line_through_a_circle_crosses_twice_in_its_own_direction() =>
        Assert.Equal(
            new Intersection2(IntersectionKind.Crossing, new(4, 3), new(-4, 3), 2),
            Intersect.LineCircle(new Line2(new(0, 3), new(-1, 0)), new Circle2(new(0, 0), 5)));

    [Theory]
    [InlineData(5.0)]
    [InlineData(5.0 + 9e-10)]
    [InlineData(5.0 - 9e-10)]
    public void Line_at_the_radius_touches_in_one_point(double height)
    {
        var met = Intersect.LineCircle(new Line2(new(-7, height), new(1, 0)), new Circle2(new(0, 0), 5));
        Assert.Equal((IntersectionKind.Tangent, 1, new Point2(0, height)), (met.Kind, met.Count, met.First));
    }

    [Fact]
    public void Line_beyond_the_radius_misses() =>
        Assert.Equal(
            Intersection2.Nowhere(IntersectionKind.None),
            Intersect.LineCircle(new Line2(new(0, 5.00001), new(1, 0)), new Circle2(new(0, 0), 5)));

    [Fact]
    public void Segment_that_starts_inside_a_circle_leaves_it_once() =>
        Assert.Equal(
            new Intersection2(IntersectionKind.Crossing, new(5, 0), default, 1),
            Intersect.LineCircle(new Segment2(new(0, 0), new(10, 0)), new Circle2(new(0, 0), 5)));

    [Fact]
    public void Arc_is_met_only_within_its_sweep()
    {
        var upper = new Arc2(new(0, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(180));
        var met = Intersect.LineCircle(new Line2(new(3, 0), new(0, 1)), upper);
        Assert.Equal((1, new Point2(3, 4)), (met.Count, met.First));
        Assert.Equal(1, Intersect.LineCircle(new Segment2(new(-4, 0), new(-4, 9)), upper).Count);
        Assert.Equal(0, Intersect.LineCircle(new Segment2(new(-4, 0), new(-4, -9)), upper).Count);
    }

    [Fact]
    public void Line_through_both_ends_of_an_arc_meets_both() =>
        Assert.Equal(2, Intersect.LineCircle(XAxis, new Arc2(new(0, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(180))).Count);

    [Fact]
    public void Corner_that_rounding_leaves_open_is_still_a_corner()
    {
        // The arc ends a billionth of a degree short of the line that it runs into at a shallow angle.
        var arc = new Arc2(new(0, 0), 10, Angle.FromDegrees(30), Angle.FromDegrees(59.999999));
        var line = new Line2(new(0, 10), Vector2.FromDirection(Angle.FromDegrees(0.001)));
        var met = Intersect.LineCircle(line, arc);
        Assert.True(met.Count >= 1);
        Assert.True(met.Nearest(arc.End)!.Value.DistanceTo(arc.End) < 1e-6);
    }

    [Fact]
    public void Circles_cross_in_two_points_counter_clockwise_from_the_first_axis()
    {
        var met = Intersect.Circles(new Circle2(new(0, 0), 5), new Circle2(new(6, 0), 5));
        Assert.Equal((IntersectionKind.Crossing, 2), (met.Kind, met.Count));
        Assert.Equal(3, met.First.X, 14);
        Assert.Equal(4, met.First.Y, 14);
        Assert.Equal(-4, met.Second.Y, 14);
    }

    [Theory]
    [InlineData(8, 3, 5)]
    [InlineData(2, 3, 5)]
    [InlineData(3, 8, 5)]
    public void Circles_that_touch_outside_or_inside_share_one_point(double distance, double radius, double expected)
    {
        var met = Intersect.Circles(new Circle2(new(0, 0), 5), new Circle2(new(distance, 0), radius));
        Assert.Equal((IntersectionKind.Tangent, 1), (met.Kind, met.Count));
        Assert.Equal(distance == 3 ? -expected : expected, met.First.X);
    }

    [Fact]
    public void Circles_apart_inside_concentric_and_equal_are_told_apart()
    {
        var circle = new Circle2(new(0, 0), 5);
        Assert.Equal(IntersectionKind.None, Intersect.Circles(circle, new Circle2(new(11, 0), 5)).Kind);
        Assert.Equal(IntersectionKind.None, Intersect.Circles(circle, new Circle2(new(1, 0), 1)).Kind);
        Assert.Equal(IntersectionKind.Parallel, Intersect.Circles(circle, new Circle2(new(0, 0), 4)).Kind);
        Assert.Equal(Intersection2.Nowhere(IntersectionKind.Coincident), Intersect.Circles(circle, circle));
    }

    [Fact]
    public void Arcs_of_one_circle_share_the_common_stretch_in_the_travel_of_the_first()
    {
        var a = new Arc2(new(0, 0), 5, Angle.FromDegrees(90), Angle.FromDegrees(-90));
        var b = new Arc2(new(0, 0), 5, Angle.FromDegrees(30), Angle.FromDegrees(300));
        var met = Intersect.Circles(a, b);
        Assert.Equal((IntersectionKind.Coincident, 2), (met.Kind, met.Count));
        Assert.Equal(90, (met.First - a.Center).Direction.Degrees, 9);
        Assert.Equal(30, (met.Second - a.Center).Direction.Degrees, 9);
    }

    [Fact]
    public void Arcs_of_one_circle_may_touch_at_both_ends()
    {
        var upper = new Arc2(new(0, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(180));
        var lower = new Arc2(new(0, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(-180));
        var met = Intersect.Circles(upper, lower);
        Assert.Equal((IntersectionKind.Tangent, 2), (met.Kind, met.Count));
        Assert.Equal(5, met.First.X, 12);
        Assert.Equal(-5, met.Second.X, 12);
    }

    [Fact]
    public void Arcs_apart_on_one_circle_do_not_meet()
    {
        var a = new Arc2(new(0, 0), 5, Angle.FromDegrees(0), Angle.FromDegrees(80));
        var b = new Arc2(new(0, 0), 5, Angle.FromDegrees(-10), Angle.FromDegrees(-80));
        Assert.Equal(Intersection2.Nowhere(IntersectionKind.None), Intersect.Circles(a, b));
    }

    [Fact]
    public void Circle_and_arc_of_it_share_the_arc()
    {
        var circle = new Circle2(new(0, 0), 5);
        var arc = new Arc2(new(0, 0), 5, Angle.FromDegrees(90), Angle.FromDegrees(-90));
        Assert.Equal(new Intersection2(IntersectionKind.Coincident, arc.End, arc.Start, 2), Intersect.Circles(circle, arc));
        Assert.Equal(new Intersection2(IntersectionKind.Coincident, arc.Start, arc.End, 2), Intersect.Circles(arc, circle));
        Assert.Equal(
            Intersection2.Nowhere(IntersectionKind.Coincident),
            Intersect.Circles(circle, new Arc2(new(0, 0), 5, default, Angle.FromDegrees(360))));
    }

    [Fact]
    public void Fillet_touches_both_flanks_where_it_ends()
    {
        // A fillet of radius 6 between the axes: its quarter circle about (6, 6) is tangent to both.
        var fillet = new Arc2(new(6, 6), 6, Angle.FromDegrees(180), Angle.FromDegrees(90));
        var met = Intersect.LineCircle(new Segment2(new(6, 0), new(40, 0)), fillet);
        Assert.Equal((IntersectionKind.Tangent, 1), (met.Kind, met.Count));
        Assert.True(met.First.DistanceTo(new(6, 0)) < 1e-12);
    }
}
