using ErrorMatching.Geometry;
using FsCheck.Fluent;

namespace ErrorMatching.Hmi.Tests;

public sealed class PlotIndexTests
{
    [Fact]
    public void The_nearest_is_that_of_looking_at_all() => Law.Holds(Gen.ListOf(Law.Point).Zip(Law.Point).Zip(Gen.Choose(1, 50).Two()), p =>
    {
        var ((points, place), (x, y)) = p;
        return new PlotIndex([.. points]).Nearest(place, x, y, double.PositiveInfinity)
            == Nearest(points, place, x, y, double.PositiveInfinity);
    });

    [Fact]
    public void Of_points_on_a_grid_with_many_as_near_it_is_the_first() =>
        Law.Holds(Gen.ListOf(Gen.Choose(0, 3).Two()).Zip(Gen.Choose(0, 3).Two()).Zip(Gen.Choose(0, 4)), p =>
    {
        var ((cells, (x, y)), reach) = p;
        Point2[] points = [.. cells.Select(c => new Point2(c.Item1, c.Item2))];
        return new PlotIndex(points).Nearest(new(x, y), 1, 1, reach) == Nearest(points, new(x, y), 1, 1, reach);
    });

    [Fact]
    public void What_is_no_number_is_never_found() => Assert.Equal(
        1,
        new PlotIndex([new(double.NaN, 0), new(9, 9), new(0, double.PositiveInfinity)]).Nearest(new(0, 0), 1, 1, double.PositiveInfinity));

    private static int Nearest(IReadOnlyList<Point2> points, Point2 place, double scaleX, double scaleY, double reach)
    {
        var (found, best) = (-1, reach * reach);
        for (var i = 0; i < points.Count; i++)
        {
            var (x, y) = ((points[i].X - place.X) * scaleX, (points[i].Y - place.Y) * scaleY);
            var square = (x * x) + (y * y);
            if (square < best || (square == best && found < 0))
            {
                (found, best) = (i, square);
            }
        }

        return found;
    }
}
