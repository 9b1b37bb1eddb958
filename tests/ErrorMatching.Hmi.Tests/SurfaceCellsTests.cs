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
    public void Each_place_has_the_color_of_its_value_and_no_other(double swing)
    {
        var told = 0;
        for (var seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            var net = Net(random, outside: [3, 7, 8]);
            double[] values = [.. Enumerable.Range(0, CountU * CountV).Select(_ => swing * ((2 * random.NextDouble()) - 1))];
            var cells = new SurfaceCells(net, values, Limit);
            for (var cell = 0; cell < (CountU - 1) * (CountV - 1); cell++)
            {
                foreach (var side in Enumerable.Range(0, 4))
                {
                    // Between two corners and the middle, by barycentric coordinates.
                    double[] share = [random.NextDouble(), random.NextDouble(), random.NextDouble()];
                    share = [.. share.Select(s => s / share.Sum())];
                    double At(Func<int, double> at) => (share[0] * at(Corner(cell, side))) + (share[1] * at(Corner(cell, (side + 1) % 4))) + (share[2] * Enumerable.Range(0, 4).Average(c => at(Corner(cell, c))));
                    var (value, place) = (At(i => values[i]), new Point2(At(i => net.Places[i].X), At(i => net.Places[i].Y)));

                    // Beside the line between two colors rounding tells.
                    if (DivergingColors.IndexOf(value - 1e-6, Limit) is var color && color == DivergingColors.IndexOf(value + 1e-6, Limit) && share.Min() > 1e-3)
                    {
                        Assert.Equal(net.Outside.Contains(cell) ? [] : [color], cells.Pieces.Where(q => IsWithin(q.Corners, place)).Select(q => q.Color));
                        told++;
                    }
                }
            }
        }

        Assert.True(told > 1000);
    }

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.5)]
    [InlineData(30)]
    public void All_pieces_together_are_the_surface(double swing)
    {
        var random = new Random(1);
        var net = Net(random, outside: [3]);
        double[] values = [.. Enumerable.Range(0, CountU * CountV).Select(_ => swing * ((2 * random.NextDouble()) - 1))];
        Assert.Equal(new SurfaceCells(net, null, Limit).Pieces.Sum(q => AreaOf(q.Corners)), new SurfaceCells(net, values, Limit).Pieces.Sum(q => AreaOf(q.Corners)), 1e-6);
    }

    [Fact]
    public void What_has_one_color_is_one_piece_a_cell()
    {
        var net = Net(new(1), outside: [3]);
        Assert.Equal(((CountU - 1) * (CountV - 1)) - 1, new SurfaceCells(net, new double[CountU * CountV], Limit).Pieces.Count);
        Assert.All(new SurfaceCells(net, null, Limit).Pieces, q => Assert.Equal(-1, q.Color));
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

    // Around a cell.
    private static int Corner(int cell, int corner)
    {
        var a = (cell / (CountV - 1) * CountV) + (cell % (CountV - 1));
        return corner switch { 0 => a, 1 => a + CountV, 2 => a + CountV + 1, _ => a + 1 };
    }

    private static double AreaOf(IReadOnlyList<Point2> corners) => Math.Abs(corners.Select((c, i) => (c - Point2.Origin).Cross(corners[(i + 1) % corners.Count] - Point2.Origin)).Sum()) / 2;

    // On the same side of all four sides.
    private static bool IsWithin(IReadOnlyList<Point2> corners, Point2 place)
    {
        var sides = corners.Select((c, i) => (corners[(i + 1) % corners.Count] - c).Cross(place - c)).ToArray();
        return sides.All(s => s > 0) || sides.All(s => s < 0);
    }
}
