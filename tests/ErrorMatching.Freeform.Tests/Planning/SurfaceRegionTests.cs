using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceRegionTests
{
    // By the winding number around the place, summed from angles: another rule than crossings,
    // the same for loops that do not cross themselves.
    [Theory]
    [InlineData(3, 1)]
    [InlineData(40, 2)]
    [InlineData(1000, 3)]
    public void A_place_belongs_to_a_star_with_a_hole_where_it_is_wound_around_once(int corners, int seed)
    {
        var random = new Random(seed);
        Point2[] Star(double least, double most) =>
            [.. Enumerable.Range(0, corners).Select(i => At(2 * Math.PI * i / corners, least + ((most - least) * random.NextDouble())))];
        Point2[][] loops = [Star(0.5, 1), Star(0.1, 0.4)];
        var region = new SurfaceRegion(loops);
        var inside = 0;
        for (var k = 0; k < 2000; k++)
        {
            var p = new Point2(3 * random.NextDouble(), 3 * random.NextDouble());
            var wound = loops.Count(l => Math.Abs(Winding(l, p)) > Math.PI) == 1;
            Assert.Equal(wound, region.Contains(p.X, p.Y));
            inside += wound ? 1 : 0;
        }

        Assert.InRange(inside, 50, 1500);
    }

    [Fact]
    public void Whole_and_changed_regions_keep_nothing_of_another()
    {
        Point2[] low = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)], high = [new(0, 2), new(1, 2), new(1, 3), new(0, 3)];
        var region = new SurfaceRegion([low]);
        Assert.True(region.Contains(0.5, 0.5));
        var other = region with { Loops = [high] };
        Assert.False(other.Contains(0.5, 0.5));
        Assert.True(other.Contains(0.5, 2.5));
        Assert.True(SurfaceRegion.Whole.Contains(7, 7));
        Assert.False(region.Contains(0.5, -1e-9));
        Assert.False(region.Contains(0.5, 1 + 1e-9));
        Assert.Equal(region, region with { });
        Assert.NotEqual(region, other);
        Assert.False(new SurfaceRegion([[new(0, 1), new(5, 1)]]).Contains(2, 1));
    }

    private static Point2 At(double angle, double radius) => new(1.5 + (radius * Math.Cos(angle)), 1.5 + (radius * Math.Sin(angle)));

    private static double Winding(Point2[] loop, Point2 p)
    {
        var sum = 0.0;
        for (var i = 0; i < loop.Length; i++)
        {
            var (a, b) = (loop[i] - p, loop[(i + 1) % loop.Length] - p);
            sum += Math.Atan2(a.Cross(b), a.Dot(b));
        }

        return sum;
    }
}
