using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class MeasuringOrderTests
{
    private static readonly PartSurface[] Designs = [Surfaces.One, Surfaces.Two, Surfaces.Three];

    [Fact]
    public void A_grid_is_measured_without_a_step_longer_than_its_spacing()
    {
        Point2[] points = [.. Enumerable.Range(0, 70).Select(k => new Point2(k % 10 * 8, k / 10 * 10))];
        var order = MeasuringOrder.Of(points, [.. Enumerable.Range(0, 70).Select(k => k / 10)]);

        // 69 steps; along the rows 63 of 8 mm, between them 6 of 10 mm.
        Assert.Equal((63 * 8) + (6 * 10), MeasuringOrder.Length(points, order), 1e-9);
        Assert.Equal(Enumerable.Range(0, 70), order.Order());
    }

    [Fact]
    public void Few_points_are_within_a_tenth_of_the_shortest_way_there_is()
    {
        var random = new Random(5);
        for (var trial = 0; trial < 20; trial++)
        {
            Point2[] points = [.. Enumerable.Range(0, 7).Select(_ => new Point2(random.NextDouble() * 75, random.NextDouble() * 63))];
            var shortest = Permutations(Enumerable.Range(0, 7).ToArray(), 0).Min(o => MeasuringOrder.Length(points, o));
            Assert.InRange(MeasuringOrder.Length(points, MeasuringOrder.Of(points, new int[7])), shortest - 1e-9, 1.1 * shortest);
        }
    }

    [Theory]
    [InlineData(0, 7, 10, null, 0)]
    [InlineData(1, 7, 7, null, 0.0002)]
    [InlineData(2, 7, null, 68, 0.0255)]
    public void The_papers_designs_are_measured_on_the_shortest_way_or_close_to_it(int design, int curves, int? each, int? points, double longer)
    {
        var plan = MeasuringPlanner.Plan(Designs[design], Surfaces.Measuring(curves, each, points), 0.2);
        Point2[] above = [.. plan.Points.Select(plan.AboveOf)];
        var way = MeasuringOrder.Length(above, [.. Enumerable.Range(0, above.Length)]);

        // Every way through all points is a tree, so none is shorter than the shortest tree.
        Assert.InRange(way, ShortestTree(above) - 1e-9, ((1 + longer) * ShortestTree(above)) + 1e-9);
    }

    [Fact]
    public void The_travel_that_a_plan_states_is_that_of_its_points()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat, Surfaces.Measuring(2, 2), 0.2);

        // Three sides of the rectangle across (63, 75, 63); at each point down and up from clearance to contact: 10 + 6 - 3 is where the center is 10 mm over the top, and 2 mm approach are in it.
        Assert.Equal(63 + 75 + 63 + (4 * 2 * 10), plan.TravelMm, 1e-9);
    }

    // By Prim.
    private static double ShortestTree(Point2[] points)
    {
        var (length, away) = (0.0, points.Select(p => p.DistanceTo(points[0])).ToArray());
        var left = Enumerable.Range(1, points.Length - 1).ToHashSet();
        while (left.Count > 0)
        {
            var next = left.MinBy(i => away[i]);
            left.Remove(next);
            length += away[next];
            foreach (var i in left)
            {
                away[i] = Math.Min(away[i], points[i].DistanceTo(points[next]));
            }
        }

        return length;
    }

    private static IEnumerable<int[]> Permutations(int[] items, int from)
    {
        if (from == items.Length)
        {
            yield return [.. items];
        }

        for (var i = from; i < items.Length; i++)
        {
            (items[from], items[i]) = (items[i], items[from]);
            foreach (var permutation in Permutations(items, from + 1))
            {
                yield return permutation;
            }

            (items[from], items[i]) = (items[i], items[from]);
        }
    }
}
