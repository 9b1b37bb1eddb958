using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi.Tests;

public sealed class SurfaceCellsTests
{
    private const int CountU = 6, CountV = 5;
    private const double Limit = 1;

    [Theory]
    [InlineData(0.2)]
    [InlineData(1)]
    [InlineData(3)]
    public void Each_part_of_a_cell_has_the_color_of_its_middle_however_its_neighbors_are_joined(double swing)
    {
        for (var seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            var net = Net(random, outside: [3, 7, 8]);
            double[] values = [.. Enumerable.Range(0, CountU * CountV).Select(_ => swing * ((2 * random.NextDouble()) - 1))];
            var cells = new SurfaceCells(net, values, Limit);
            for (var cell = 0; cell < (CountU - 1) * (CountV - 1); cell++)
            {
                for (var part = 0; part < SurfaceCells.Parts * SurfaceCells.Parts; part++)
                {
                    var (s, t) = ((double)(part / SurfaceCells.Parts), (double)(part % SurfaceCells.Parts));
                    var color = DivergingColors.IndexOf(Value(values, cell, (s + 0.5) / SurfaceCells.Parts, (t + 0.5) / SurfaceCells.Parts), Limit);
                    var place = Place(net, cell, (s + 0.05 + (0.9 * random.NextDouble())) / SurfaceCells.Parts, (t + 0.05 + (0.9 * random.NextDouble())) / SurfaceCells.Parts);
                    var found = cells.Quadrangles.Where(q => IsWithin(q.Corners, place)).Select(q => q.Color);
                    Assert.Equal(net.Outside.Contains(cell) ? [] : [color], found);
                }
            }
        }
    }

    [Fact]
    public void What_has_one_color_is_one_quadrangle_a_cell()
    {
        var net = Net(new(1), outside: [3]);
        Assert.Equal(((CountU - 1) * (CountV - 1)) - 1, new SurfaceCells(net, new double[CountU * CountV], Limit).Quadrangles.Count);
        Assert.All(new SurfaceCells(net, null, Limit).Quadrangles, q => Assert.Equal(-1, q.Color));

        // Along u alone: three strips a cell, whichever way it changes.
        double[] along = [.. Enumerable.Range(0, CountU * CountV).Select(i => 0.3 * (i / CountV))];
        double[] across = [.. Enumerable.Range(0, CountU * CountV).Select(i => 0.3 * (i % CountV))];
        Assert.All(new[] { along, across }, v => Assert.InRange(new SurfaceCells(net, v, Limit).Quadrangles.Count, 30, 3 * 19));
    }

    [Fact]
    public void The_border_goes_around_the_piece_and_around_what_is_not_of_it()
    {
        var border = new SurfaceCells(Net(new(1), outside: [6]), null, Limit).Border;

        // Around all, and around the one cell in the midst of it.
        Assert.Equal((2 * (CountU - 1)) + (2 * (CountV - 1)) + 4, border.Count);
        Assert.All(border.SelectMany(b => new[] { b.From, b.To }).GroupBy(p => p), p => Assert.Equal(2, p.Count()));
    }

    private static SurfaceNet Net(Random random, int[] outside) => new(
        CountU, CountV, [.. Enumerable.Range(0, CountU * CountV).Select(i => new Point3((10 * (i / CountV)) + (3 * random.NextDouble()), (10 * (i % CountV)) + (3 * random.NextDouble()), random.NextDouble()))], outside);

    private static double Value(double[] values, int cell, double s, double t) => Between(cell, i => values[i], s, t);

    private static Point2 Place(SurfaceNet net, int cell, double s, double t) => new(Between(cell, i => net.Places[i].X, s, t), Between(cell, i => net.Places[i].Y, s, t));

    private static double Between(int cell, Func<int, double> at, double s, double t)
    {
        var a = (cell / (CountV - 1) * CountV) + (cell % (CountV - 1));
        return (at(a) * (1 - s) * (1 - t)) + (at(a + CountV) * s * (1 - t)) + (at(a + CountV + 1) * s * t) + (at(a + 1) * (1 - s) * t);
    }

    // On the same side of all four sides.
    private static bool IsWithin(IReadOnlyList<Point2> corners, Point2 place)
    {
        var sides = corners.Select((c, i) => (corners[(i + 1) % corners.Count] - c).Cross(place - c)).ToArray();
        return sides.All(s => s > 0) || sides.All(s => s < 0);
    }
}
