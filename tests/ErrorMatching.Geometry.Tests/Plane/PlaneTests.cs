using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Plane;

/// <summary>Signs and turns of the plane's value types: left is positive, counter-clockwise is positive, everywhere.</summary>
public class PlaneTests
{
    [Fact]
    public void Inverse_transform_brings_every_point_back() =>
        Draw.Law(Draw.Transform.Zip(Draw.Point), p => p.Item1.Inverse().Apply(p.Item1.Apply(p.Item2)).DistanceTo(p.Item2) < 1e-10
            && p.Item1.Apply(p.Item1.Inverse().Apply(p.Item2)).DistanceTo(p.Item2) < 1e-10);

    [Fact]
    public void Transform_keeps_distances_and_a_mirror_swaps_left_and_right() =>
        Draw.Law(Draw.Transform.Zip(Draw.Point.Three()), p =>
        {
            var (t, (a, b, c)) = p;
            var (before, after) = ((b - a).Cross(c - a), (t.Apply(b) - t.Apply(a)).Cross(t.Apply(c) - t.Apply(a)));
            return Math.Abs(t.Apply(a).DistanceTo(t.Apply(b)) - a.DistanceTo(b)) < 1e-10
                && Math.Abs((t.Mirror == Mirror.None ? before : -before) - after) < 1e-7;
        });

    [Fact]
    public void Mirror_comes_before_rotation_and_rotation_before_translation() =>
        Assert.Equal(
            0, new RigidTransform2(Mirror.X, Angle.FromDegrees(90), new(10, 0)).Apply(new Point2(2, 1)).DistanceTo(new(9, -2)), 14);

    [Fact]
    public void Rotation_about_a_point_keeps_it_and_turns_counter_clockwise()
    {
        var turn = RigidTransform2.RotateAbout(new(3, 4), Angle.FromDegrees(90));
        Assert.True(turn.Apply(new Point2(3, 4)).DistanceTo(new(3, 4)) < 1e-14);
        Assert.True(turn.Apply(new Point2(5, 4)).DistanceTo(new(3, 6)) < 1e-14);
    }

    [Fact]
    public void Left_of_a_line_is_positive_and_offset_goes_there()
    {
        var line = new Line2(new(0, 0), new(2, 0));
        Assert.Equal(3, line.SignedDistance(new(7, 3)));
        Assert.Equal(new Point2(0, 3), line.Offset(3).Origin);
    }

    [Fact]
    public void Angle_between_directions_is_that_of_equation_1() =>
        Draw.Law(Draw.Angle.Two(), p =>
        {
            var (a, b) = (Vector2.FromDirection(p.Item1), Vector2.FromDirection(p.Item2));
            var expected = Math.Acos(Math.Clamp(a.Dot(b) / (a.Length * b.Length), -1, 1));
            return Math.Abs(Angle.Between(a * 7, b).Radians - expected) < 1e-7;
        });

    [Theory]
    [InlineData(370, 10)]
    [InlineData(-190, 170)]
    [InlineData(180, 180)]
    [InlineData(-180, 180)]
    [InlineData(720, 0)]
    public void Normalized_angle_is_in_the_half_open_turn(double degrees, double expected) =>
        Assert.Equal(expected, Angle.FromDegrees(degrees).Normalized.Degrees, 10);

    [Fact]
    public void Arc_between_points_runs_the_way_it_is_told()
    {
        var left = Arc2.Between(new(5, 0), new(0, 5), new(0, 0), counterClockwise: true);
        var right = Arc2.Between(new(5, 0), new(0, 5), new(0, 0), counterClockwise: false);
        Assert.Equal(90, left.Sweep.Degrees, 12);
        Assert.Equal(-270, right.Sweep.Degrees, 12);
        Assert.Equal(360, Arc2.Between(new(5, 0), new(5, 0), new(0, 0), counterClockwise: true).Sweep.Degrees, 12);
        Assert.True((left.TangentAt(0) - new Vector2(0, 1)).Length < 1e-15);
        Assert.True((right.TangentAt(0) - new Vector2(0, -1)).Length < 1e-15);
    }

    [Fact]
    public void Nearest_point_of_an_arc_is_nearer_than_any_sample() =>
        Draw.Law(
            Draw.Arc.Zip(Draw.Point),
            p => Enumerable.Range(0, 50).All(i => p.Item1.DistanceTo(p.Item2) <= p.Item2.DistanceTo(p.Item1.At(i / 49.0)) + 1e-10));

    [Fact]
    public void Nearest_point_of_a_segment_is_nearer_than_any_sample() =>
        Draw.Law(
            Draw.Segment.Zip(Draw.Point),
            p => Enumerable.Range(0, 50).All(i => p.Item1.DistanceTo(p.Item2) <= p.Item2.DistanceTo(p.Item1.At(i / 49.0)) + 1e-10));

    [Fact]
    public void Circle_through_three_points_meets_them() =>
        Draw.Law(Draw.Point.Three(), p =>
        {
            var (a, b, c) = p;
            var slender = Math.Abs((b - a).Cross(c - a)) < 1;
            return slender || new[] { a, b, c }.All(q => Math.Abs(Circle2.Through(a, b, c).SignedDistance(q)) < 1e-6);
        });

    [Fact]
    public void Degenerate_elements_are_refused_by_name()
    {
        Refused.With(GeometryError.CollinearPoints, () => Circle2.Through(new(0, 0), new(1, 1), new(2, 2)));
        Refused.With(GeometryError.CoincidentPoints, () => Line2.Through(new(1, 1), new(1, 1)));
        Refused.With(GeometryError.CoincidentPoints, () => new Circle2(new(1, 1), 2).Foot(new(1, 1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Circle2(new(0, 0), -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Circle2(new(0, 0), double.NaN));
    }

    [Fact]
    public void Planes_keep_the_axis_order_that_makes_counter_clockwise_positive()
    {
        var point = new Point3(1, 2, 3);
        foreach (var (plane, projected, height) in ((CoordinatePlane, Point2, double)[])
            [(CoordinatePlane.XY, new(1, 2), 3), (CoordinatePlane.ZX, new(3, 1), 2), (CoordinatePlane.YZ, new(2, 3), 1)])
        {
            Assert.Equal((projected, height), (plane.Project(point), plane.Height(point)));
            Assert.Equal(point, plane.Lift(projected, height));
        }
    }
}
