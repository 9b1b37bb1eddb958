using System.Globalization;

namespace ErrorMatching.Freeform.Tests;

public sealed class ContourRingsTests
{
    private const int Count = 41;

    // A linear field is interpolated exactly: the part of a square of 100 pixels above a quarter has three quarters of its area.
    [Theory]
    [InlineData(0.25, 7500)]
    [InlineData(0.5, 5000)]
    [InlineData(0.99, 100)]
    [InlineData(double.NegativeInfinity, 10000)]
    [InlineData(1.01, 0)]
    public void What_is_above_a_level_has_its_exact_area(double level, double area)
    {
        Assert.Equal(area, Area(Rings((x, _) => x / 100).Above(level)), 6);
        Assert.Equal(area, Area(Rings((_, y) => y / 100).Above(level)), 6);
        Assert.Equal(area, Area(Rings((x, _) => 1 - (x / 100)).Above(level)), 6);
    }

    // The circle of radius 30 about the middle: pi 900. Chords of a quarter of a cell's bend lie inside it.
    [Fact]
    public void A_hill_has_one_round_ring_and_a_pit_a_hole()
    {
        static double Distance(double x, double y) => Math.Sqrt(((x - 50) * (x - 50)) + ((y - 50) * (y - 50)));
        var hill = Rings((x, y) => -Distance(x, y)).Above(-30);
        Assert.Single(Parts(hill));
        Assert.InRange(Area(hill), Math.PI * 900 * 0.99, Math.PI * 900);
        var pit = Rings(Distance).Above(30);
        Assert.Equal(2, Parts(pit).Length);
        Assert.InRange(Area(pit), 10000 - (Math.PI * 900), 10000 - (Math.PI * 900 * 0.99));
        Assert.All(Points(hill), p => Assert.Equal(30, Distance(p.X, p.Y), 0.2));
    }

    // Two opposite corners above the level are joined if the middle is above, too.
    [Theory]
    [InlineData(0.4, 1)]
    [InlineData(0.6, 2)]
    public void Opposite_corners_are_joined_through_the_middle(double level, int parts)
    {
        foreach (var values in new double[][] { [1, 0, 0, 1], [0, 1, 1, 0] })
        {
            var rings = new ContourRings(2, 2, [(0, 0), (0, 1), (1, 0), (1, 1)], values).Above(level);
            Assert.Equal(parts, Parts(rings).Length);
        }
    }

    [Fact]
    public void Every_ring_is_closed_and_the_areas_of_random_fields_shrink_with_the_level()
    {
        var random = new Random(7);
        for (var round = 0; round < 20; round++)
        {
            double[] values = [.. Enumerable.Range(0, Count * Count).Select(_ => random.NextDouble())];
            var rings = new ContourRings(Count, Count, [.. Places()], values);
            var areas = Enumerable.Range(0, 11).Select(k => Area(rings.Above(k / 10.0))).ToArray();
            Assert.Equal(10000, areas[0], 6);
            Assert.Equal(areas.OrderDescending(), areas);

            // The area is that of all cells with each cut by its own level set: about the share of values above.
            Assert.Equal(5000, areas[5], 400.0);
        }
    }

    private static ContourRings Rings(Func<double, double, double> field) =>
        new(Count, Count, [.. Places()], [.. Places().Select(p => field(p.X, p.Y))]);

    private static IEnumerable<(double X, double Y)> Places() =>
        from i in Enumerable.Range(0, Count) from j in Enumerable.Range(0, Count) select (100.0 * i / (Count - 1), 100.0 * j / (Count - 1));

    private static string[] Parts(string data) => data.Split('Z', StringSplitOptions.RemoveEmptyEntries);

    private static IEnumerable<(double X, double Y)> Points(string part) => part[1..].TrimEnd('Z').Split('L').Select(p =>
        (double.Parse(p.Split(',')[0], CultureInfo.InvariantCulture), double.Parse(p.Split(',')[1], CultureInfo.InvariantCulture)));

    // Rings around holes turn the other way, so their areas are negative.
    private static double Area(string data) => Math.Abs(Parts(data).Sum(part =>
    {
        var points = Points(part).ToArray();
        return points.Select((p, k) => (p, Next: points[(k + 1) % points.Length])).Sum(s => (s.p.X * s.Next.Y) - (s.Next.X * s.p.Y)) / 2;
    }));
}
