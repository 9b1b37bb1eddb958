using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The highest ridge of a strip, found by four places at once where that is enough, against every place looked at closely.</summary>
public sealed class StripHeightTests
{
    private const double Micrometer = 0.001;

    // With an edge far around it, nothing is cut off a surface either, but places are looked at one by one.
    private static readonly SurfaceRegion FarAround = new([[new(-1, -1), new(2, -1), new(2, 2), new(-1, 2)]]);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    public void Four_places_at_once_miss_no_ridge(int number)
    {
        var surface = Surface(number);
        var (offset, closely) = (new OffsetSurface(surface, 3, 0), new OffsetSurface(surface with { Region = FarAround }, 3, 0));
        foreach (var v in new[] { 0.0, 0.31, 0.77 })
        {
            foreach (var width in new[] { 0.0005, 0.002 })
            {
                var (first, second) = (Pass(offset, v), Pass(offset, v + width));

                var (wanted, _) = new StripHeight(closely, [], Micrometer).Measure(first, v, second, v + width);
                var (found, _) = new StripHeight(offset, [], Micrometer).Measure(first, v, second, v + width);

                // Where rounded polylines bend inwards, a normal meets two pieces of them; looking closely takes the first, which need not be the one met first.
                Assert.InRange(found, wanted - 0.000005, wanted + 1e-12);
            }
        }
    }

    [Fact]
    public void Ridge_on_a_level_is_that_of_two_balls()
    {
        // 3 - sqrt(9 - 0.1^2) where passes lie 0.2 mm apart.
        var offset = new OffsetSurface(Shapes.Plane(20, 10), 3, 0);

        var (height, _) = new StripHeight(offset, [], 1).Measure(Pass(offset, 0.5), 0.5, Pass(offset, 0.52), 0.52);

        Assert.Equal(3 - Math.Sqrt(9 - 0.01), height, 1e-6);
    }

    // The paper's designs, one over skewed parameters, and one with weights.
    private static PartSurface Surface(int number) => number switch
    {
        4 => new("skewed", new(KnotVector.Clamped(1, [0, 1]), KnotVector.Clamped(1, [0, 1]), [new(0, 0, 0), new(40, 40, 0), new(50, 0, 1), new(90, 40, 3)]), SurfaceRegion.Whole, 1),
        5 => Shapes.Cylinder(25, 40),
        _ => Shapes.Design(number),
    };

    private static CenterLine[] Pass(OffsetSurface offset, double v)
    {
        var line = new CenterLine();
        new PassBuilder(offset, new(4, 0, Micrometer), Micrometer, 0.4 * Micrometer).Build(new([new(0, v), new(1, v)], 1, 0.25), line);
        return [line];
    }
}
