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
    public void Along_its_sides_a_cell_has_the_colors_of_its_values_and_nowhere_two(double swing)
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
                    // Just inside of a side, between two corners; then anywhere within.
                    var (from, to, share) = (Corner(cell, side), Corner(cell, (side + 1) % 4), 0.1 + (0.8 * random.NextDouble()));
                    var (value, middle) = (values[from] + (share * (values[to] - values[from])), Middle(net, cell));
                    var place = Above(net, from).Lerp(Above(net, to), share);
                    var color = DivergingColors.IndexOf(value - 1e-4, Limit);
                    if (color == DivergingColors.IndexOf(value + 1e-4, Limit))
                    {
                        Assert.Equal(net.Outside.Contains(cell) ? [] : [color], At(place.Lerp(middle, 1e-7)));
                        told++;
                    }

                    int[] corners = [.. Enumerable.Range(0, 4).Select(c => DivergingColors.IndexOf(values[Corner(cell, c)], Limit))];
                    var within = At(place.Lerp(middle, random.NextDouble()));
                    Assert.True(
                        net.Outside.Contains(cell)
                            ? within.Length == 0
                            : within.Length <= 1 && within.All(c => c >= corners.Min() && c <= corners.Max()));
                }
            }

            int[] At(Point2 place) => [.. cells.Pieces.Where(q => IsWithin(q.Corners, place)).Select(q => q.Color)];
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
        Assert.Equal(
            new SurfaceCells(net, null, Limit).Pieces.Sum(q => AreaOf(q.Corners)),
            new SurfaceCells(net, values, Limit).Pieces.Sum(q => AreaOf(q.Corners)),
            1e-6);
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
        CountU,
        CountV,
        [
            .. Enumerable.Range(0, CountU * CountV).Select(i => new Point3(
                (10 * (i / CountV)) + (3 * random.NextDouble()), (10 * (i % CountV)) + (3 * random.NextDouble()), random.NextDouble()))],
        outside);

    // Around a cell.
    private static int Corner(int cell, int corner)
    {
        var a = (cell / (CountV - 1) * CountV) + (cell % (CountV - 1));
        return corner switch { 0 => a, 1 => a + CountV, 2 => a + CountV + 1, _ => a + 1 };
    }

    private static Point2 Above(SurfaceNet net, int place) => new(net.Places[place].X, net.Places[place].Y);

    private static Point2 Middle(SurfaceNet net, int cell) => new(
        Enumerable.Range(0, 4).Average(c => Above(net, Corner(cell, c)).X),
        Enumerable.Range(0, 4).Average(c => Above(net, Corner(cell, c)).Y));

    private static double AreaOf(IReadOnlyList<Point2> corners) =>
        Math.Abs(corners.Select((c, i) => (c - Point2.Origin).Cross(corners[(i + 1) % corners.Count] - Point2.Origin)).Sum()) / 2;

    // On the same side of all four sides.
    private static bool IsWithin(IReadOnlyList<Point2> corners, Point2 place)
    {
        var sides = corners.Select((c, i) => (corners[(i + 1) % corners.Count] - c).Cross(place - c)).ToArray();
        return sides.All(s => s > 0) || sides.All(s => s < 0);
    }
}
