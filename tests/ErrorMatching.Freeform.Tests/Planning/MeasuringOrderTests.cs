using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class MeasuringOrderTests
{
    private static readonly PartSurface[] Designs = [Surfaces.One, Surfaces.Two, Surfaces.Three];

    [Fact]
    public void A_grid_is_measured_without_a_step_longer_than_its_spacing()
    {
        Point2[] points = [.. Enumerable.Range(0, 70).Select(k => new Point2(k % 10 * 8, k / 10 * 10))];
        var order = MeasuringOrder.Find(points, [.. Enumerable.Range(0, 70).Select(k => k / 10)]);

        // 69 steps; along the rows 63 of 8 mm, between them 6 of 10 mm.
        Assert.Equal((63 * 8) + (6 * 10), MeasuringOrder.Length(points, order), 1e-9);
        Assert.Equal(Enumerable.Range(0, 70), order.Order());
    }

    [Fact]
    public void Few_points_are_measured_on_the_shortest_way_there_is()
    {
        var random = new Random(5);
        for (var trial = 0; trial < 100; trial++)
        {
            var points = Scattered(random, 1 + (trial % 7));
            var shortest = Permutations([.. Enumerable.Range(0, points.Length)], 0).Min(o => MeasuringOrder.Length(points, o));
            Assert.Equal(shortest, MeasuringOrder.Length(points, MeasuringOrder.Find(points, new int[points.Length])), 1e-9);
        }
    }

    // Against a bound that few steps bring in, which is some way below the shortest. Some points come twice; at last all are one place.
    [Theory]
    [InlineData(300, 0.12)]
    [InlineData(1000, 0.2)]
    public void Each_of_many_points_comes_once_and_the_way_is_short(int count, double longer)
    {
        var points = Scattered(new Random(count), count);
        points.AsSpan(0, 5).CopyTo(points.AsSpan(count - 5));
        var order = MeasuringOrder.Find(points, [.. Enumerable.Range(0, count).Select(k => k / 10)]);

        Assert.Equal(Enumerable.Range(0, count), order.Order());
        Assert.InRange(
            MeasuringOrder.Length(points, order), 0, (1 + longer) * LeastLength(points, MeasuringOrder.Length(points, order), 300));
        Assert.Equal(Enumerable.Range(0, 20), MeasuringOrder.Find(new Point2[20], new int[20]).Order());
    }

    [Theory]
    [InlineData(0, 7, 10, null)]
    [InlineData(1, 7, 7, null)]
    [InlineData(2, 7, null, 68)]
    public void The_papers_designs_are_measured_on_the_shortest_way_there_is(int design, int curves, int? each, int? points)
    {
        var plan = MeasuringPlanner.Plan(Designs[design], Surfaces.Measuring(curves, each, points), 0.2);
        Point2[] above = [.. plan.Points.Select(plan.AboveOf)];
        var way = MeasuringOrder.Length(above, [.. Enumerable.Range(0, above.Length)]);

        // To 0.01 mm: as far as the bound comes in so many steps.
        Assert.InRange(way - LeastLength(above, way, 3000), -1e-6, 0.01);
    }

    [Fact]
    public void The_travel_that_a_plan_states_is_that_of_its_points()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat, Surfaces.Measuring(2, 2), 0.2);

        // Three sides of the rectangle across (63, 75, 63); at each point down and up from clearance to contact: 10 + 6 - 3 is where the
        // center is 10 mm over the top, and 2 mm approach are in it.
        Assert.Equal(63 + 75 + 63 + (4 * 2 * 10), plan.TravelMm, 1e-9);
    }

    private static Point2[] Scattered(Random random, int count) =>
        [.. Enumerable.Range(0, count).Select(_ => new Point2(random.NextDouble() * 75, random.NextDouble() * 63))];

    // No way through all points is shorter: Held and Karp, The traveling-salesman problem and minimum spanning trees, Operations Research
    // 18 (1970), for open ways. Whatever weight each point has, a way has each joint's length and the weights of both its points, and is a
    // tree; the weights are then counted twice at each point but at the ends once.
    // They rise where the shortest tree has many joints, and fall where it has one.
    private static double LeastLength(Point2[] points, double way, int steps)
    {
        var (least, weights) = (0.0, new double[points.Length]);
        for (var step = 0; step < steps; step++)
        {
            var (length, joints) = ShortestTree(points, weights);
            var ends = Enumerable.Range(0, points.Length).OrderBy(i => weights[i]).Take(2).ToArray();
            length += weights[ends[0]] + weights[ends[1]] - (2 * weights.Sum());
            least = Math.Max(least, length);
            joints[ends[0]]++;
            joints[ends[1]]++;
            var off = joints.Sum(j => (j - 2) * (j - 2));
            var stride = 2 * Math.Pow(0.998, Math.Max(0, step - 300)) * Math.Max(way - length, 0.01) / Math.Max(off, 1);
            for (var i = 0; i < points.Length; i++)
            {
                weights[i] += stride * (joints[i] - 2);
            }
        }

        return least;
    }

    // By Prim.
    private static (double Length, int[] Joints) ShortestTree(Point2[] points, double[] weights)
    {
        var (length, joints, at) = (0.0, new int[points.Length], 0);
        var (away, from, isIn) = (new double[points.Length], new int[points.Length], new bool[points.Length]);
        Array.Fill(away, double.PositiveInfinity);
        for (var count = 1; count < points.Length; count++)
        {
            isIn[at] = true;
            var next = -1;
            for (var i = 0; i < points.Length; i++)
            {
                if (!isIn[i])
                {
                    var joint = points[at].DistanceTo(points[i]) + weights[at] + weights[i];
                    (away[i], from[i]) = joint < away[i] ? (joint, at) : (away[i], from[i]);
                    next = next < 0 || away[i] < away[next] ? i : next;
                }
            }

            length += away[next];
            joints[next]++;
            joints[from[next]]++;
            at = next;
        }

        return (length, joints);
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
