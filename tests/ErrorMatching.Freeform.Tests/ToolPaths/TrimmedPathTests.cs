using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Passes over a region that trimming leaves.</summary>
public sealed class TrimmedPathTests
{
    // 20 x 10 mm with a round hole of radius 2.5 in the middle; parameters are shares of the sides.
    private static PartSurface WithHole() => Shapes.Plane(20, 10) with
    {
        Region = new([[new(0.05, 0.1), new(0.95, 0.1), new(0.95, 0.9), new(0.05, 0.9)], Circle(0.5, 0.5, 2.5)])
    };

    private static Point2[] Circle(double u, double v, double radius) =>
        [
            .. Enumerable.Range(0, 90).Select(i => new Point2(
                u + (radius / 20 * Math.Cos(i * Math.PI / 45)), v + (radius / 10 * Math.Sin(i * Math.PI / 45))))];

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_tool_touches_only_the_region(bool zigzag)
    {
        var path = Plans.Path(WithHole(), Plans.Passes(0.01, 0.01, zigzag: zigzag));

        foreach (var move in path.Moves().Where(m => m is { IsRapid: false, Center.Z: < 3.001 }))
        {
            var (x, y) = (move.Center.X, move.Center.Y);
            Assert.InRange(x, 1 - 1e-3, 19 + 1e-3);
            Assert.InRange(y, 1 - 1e-3, 9 + 1e-3);
            Assert.True(Math.Sqrt(((x - 10) * (x - 10)) + ((y - 5) * (y - 5))) > 2.48, $"{move}");
        }
    }

    [Fact]
    public void The_tool_goes_up_to_pass_over_the_hole()
    {
        var moves = Plans.Path(WithHole(), Plans.Passes(0.01, 0.01)).Moves().ToList();

        var over = 0;
        for (var i = 1; i < moves.Count; i++)
        {
            var (a, b) = (moves[i - 1].Center, moves[i].Center);
            if (a.Y == b.Y && Math.Abs(a.Y - 5) < 2 && Math.Min(a.X, b.X) < 8 && Math.Max(a.X, b.X) > 12)
            {
                Assert.True(moves[i].IsRapid);
                Assert.Equal(13, a.Z, 1e-9);
                Assert.Equal(13, b.Z, 1e-9);
                over++;
            }
        }

        Assert.True(over > 5);
    }

    [Fact]
    public void No_place_of_the_region_is_left_higher_than_certified()
    {
        var surface = WithHole();
        var path = Plans.Path(surface, Plans.Passes(0.01, 0.01));

        var ball = new VirtualBall(3, path.Moves());
        var (random, highest) = (new Random(1), 0.0);
        for (var i = 0; i < 4000; i++)
        {
            var (u, v) = (random.NextDouble(), random.NextDouble());
            highest = surface.Region.Contains(u, v) ? Math.Max(highest, ball.Left(new(20 * u, 10 * v, 0), new(0, 0, 1))) : highest;
        }

        Assert.InRange(highest, 0.005, path.Certificate.ScallopMm + 0.00002);
        Assert.True(path.Certificate.ScallopMm <= 0.01);
    }
}
