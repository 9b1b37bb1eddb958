namespace ErrorMatching.Geometry.Tests.Fits;

public class ExtremeCircleTests
{
    private const int Cases = 300;

    // A square's corners: the circle around them has its half diagonal, and no circle that holds none of them inside is larger than that
    // one.
    [Fact]
    public void A_square_has_its_own_circle_inside_and_around()
    {
        Point2[] square = [new(11, -21), new(9, -21), new(9, -19), new(11, -19)];
        foreach (var circle in new[] { ExtremeCircle.Inscribed(square).Circle, ExtremeCircle.Circumscribed(square).Circle })
        {
            Assert.True(circle.Center.DistanceTo(new(10, -20)) < 1e-12);
            Assert.Equal(Math.Sqrt(2), circle.Radius, 12);
        }
    }

    // Points on an ellipse of half axes a and b, ends of both among them: the circle around has the radius a, the circle inside b.
    [Fact]
    public void An_oval_lies_between_its_half_axes()
    {
        Point2[] oval = [
            .. Enumerable.Range(0, 16).Select(i => new Point2(
                5 + (10.02 * Math.Cos(i * Math.PI / 8)), 3 + (9.99 * Math.Sin(i * Math.PI / 8))))];
        var around = ExtremeCircle.Circumscribed(oval, 0.002);
        Assert.Equal(10.02, around.Circle.Radius, 12);
        Assert.Equal([0, 8], around.Contacts);
        Assert.Equal(0.002 / Math.Sqrt(2), around.RadiusStandardError, 12);
        Assert.True(around.Circle.Center.DistanceTo(new(5, 3)) < 1e-12);
        var inside = ExtremeCircle.Inscribed(oval);
        Assert.True(inside.Circle.Center.DistanceTo(Brute(oval, -1).Center) < 1e-9);
        Assert.InRange(inside.Circle.Radius, 9.99, 9.991);
    }

    [Fact]
    public void Even_contacts_have_the_errors_of_the_closed_form()
    {
        // Three rays at 120 degrees: the radius is the mean of three distances, and the design has the Gram matrix diag(3/2, 3/2, 3).
        var fit = ExtremeCircle.Inscribed(
            [.. Enumerable.Range(0, 3).Select(i => new Circle2(new(1, 2), 7).At(Angle.FromDegrees(120 * i)))], 0.003);
        Assert.Equal(7, fit.Circle.Radius, 12);
        Assert.Equal(0.003 / Math.Sqrt(1.5), fit.CenterStandardError.X, 12);
        Assert.Equal(0.003 / Math.Sqrt(1.5), fit.CenterStandardError.Y, 12);
        Assert.Equal(0.003 / Math.Sqrt(3), fit.RadiusStandardError, 12);
    }

    [Fact]
    public void The_circle_inside_is_the_largest_of_all_through_three_points_that_holds_none()
    {
        for (var seed = 0; seed < Cases; seed++)
        {
            var points = Ring(seed);
            var (found, brute) = (ExtremeCircle.Inscribed(points), Brute(points, -1));
            Assert.True(
                Math.Abs(found.Circle.Radius - brute.Radius) < 1e-9 && found.Circle.Center.DistanceTo(brute.Center) < 1e-7,
                $"ring {seed}: {found.Circle} is not {brute}");
            Assert.True(found.Residuals.Min() > -1e-9, $"ring {seed}");
            Assert.All(found.Contacts, i => Assert.Equal(0, found.Residuals[i], 9));
        }
    }

    [Fact]
    public void The_circle_around_is_the_smallest_of_all_through_two_or_three_points_that_holds_all()
    {
        for (var seed = 0; seed < Cases; seed++)
        {
            var points = Ring(seed);
            var (found, brute) = (ExtremeCircle.Circumscribed(points), Brute(points, 1));
            Assert.True(
                Math.Abs(found.Circle.Radius - brute.Radius) < 1e-9 && found.Circle.Center.DistanceTo(brute.Center) < 1e-7,
                $"ring {seed}: {found.Circle} is not {brute}");
        }
    }

    [Fact]
    public void Points_that_leave_half_a_turn_open_have_no_largest_circle_inside()
    {
        var circle = new Circle2(new(3, 4), 10);
        var e = Assert.Throws<GeometryException>(() => ExtremeCircle.Inscribed(
            [.. Enumerable.Range(0, 7).Select(i => circle.At(Angle.FromDegrees(25 * i)))]));
        Assert.Equal((GeometryError.NotAround, true), (e.Error, e.Message.Contains("210 degrees", StringComparison.Ordinal)));
        Assert.Equal(
            10, ExtremeCircle.Inscribed([.. Enumerable.Range(0, 8).Select(i => circle.At(Angle.FromDegrees(26 * i)))]).Circle.Radius, 9);
        Assert.Equal(
            178,
            ExtremeCircle.LargestGap(circle.Center, [.. Enumerable.Range(0, 8).Select(i => circle.At(Angle.FromDegrees(26 * i)))]).Degrees,
            9);
    }

    [Fact]
    public void Points_on_one_place_have_no_circle_around() =>
        Assert.Equal(
            GeometryError.CoincidentPoints,
            Assert.Throws<GeometryException>(() => ExtremeCircle.Circumscribed([new(1, 1), new(1, 1), new(1, 1)])).Error);

    // Rough rings of 3 to 14 points in any order, no gap of half a turn.
    private static Point2[] Ring(int seed)
    {
        var random = new Random(seed);
        var count = random.Next(3, 15);
        var (center, radius, rough) = (
            new Point2(100 * random.NextDouble(), 100 * random.NextDouble()),
            1 + (30 * random.NextDouble()),
            Math.Pow(10, -1 - (4 * random.NextDouble())));
        Point2[] points = [.. Enumerable.Range(0, count).Select(i => center
            + (
                Vector2.FromDirection(Angle.FromDegrees(
                    (360.0 / count * i) + (25 * random.NextDouble()))) * (radius * (1 + (rough * random.NextDouble())))))];
        random.Shuffle(points);
        return points;
    }

    // All circles through two ends of a diameter or three points, of which the smallest that holds all points, or the largest that holds
    // none and whose center lies among its three.
    private static Circle2 Brute(Point2[] points, int sign)
    {
        var found = new List<Circle2>();
        for (var i = 0; i < points.Length; i++)
        {
            for (var j = 0; j < i; j++)
            {
                if (sign > 0)
                {
                    found.Add(new(points[i].Lerp(points[j], 0.5), points[i].DistanceTo(points[j]) / 2));
                }

                for (var k = 0; k < j; k++)
                {
                    var circle = Circle2.Through(points[i], points[j], points[k]);
                    var (a, b, c) = (points[i] - circle.Center, points[j] - circle.Center, points[k] - circle.Center);
                    if (sign > 0 || (Math.Sign(a.Cross(b)) == Math.Sign(b.Cross(c)) && Math.Sign(b.Cross(c)) == Math.Sign(c.Cross(a))))
                    {
                        found.Add(circle);
                    }
                }
            }
        }

        return found.Where(c => points.All(p => sign * c.SignedDistance(p) <= 1e-10)).MinBy(c => sign * c.Radius);
    }
}
