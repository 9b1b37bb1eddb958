using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The highest ridge of a strip, found by four places at once where that is enough, against every place looked at closely and
/// against every piece of the polylines.</summary>
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

                // Above the truth, or the first place that is too high. Below looking closely by 5 nm at one place of design 3: its
                // polyline bends inwards, the normal meets two pieces, and looking closely takes the second one.
                var truth = Highest(offset, first[0], v, second[0], v + width);
                Assert.InRange(found, Math.Min(truth, Micrometer) - 1e-9, wanted + 1e-12);
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

    /// <summary>The highest ridge, each place of it found by halving and against every piece of both polylines.</summary>
    private static double Highest(OffsetSurface offset, CenterLine first, double v, CenterLine second, double next)
    {
        var highest = double.NegativeInfinity;
        foreach (var line in new[] { first, second })
        {
            for (var i = 0; i < (2 * line.Count) - 1; i++)
            {
                var (before, behind) = (line.Places[i / 2].X, line.Places[(i + 1) / 2].X);
                highest = Math.Max(highest, Ridge((before + behind) / 2));
            }
        }

        return highest;

        double Ridge(double u)
        {
            var (low, high) = (0.0, 1.0);
            for (var k = 0; k < 40; k++)
            {
                var middle = (low + high) / 2;
                var (place, normal) = offset.Left(u, v + ((next - v) * middle));
                (low, high) = Enters(place, normal, first) < Enters(place, normal, second) ? (middle, high) : (low, middle);
            }

            var (on, up) = offset.Left(u, v + ((next - v) * low));
            return Math.Min(Enters(on, up, first), Enters(on, up, second));
        }

        double Enters(Point3 place, Vector3 normal, CenterLine line)
        {
            var least = double.PositiveInfinity;
            for (var i = 0; i + 1 < line.Count; i++)
            {
                least = Math.Min(least, Entry(place, normal, line.Centers[i], line.Centers[i + 1], offset.RadiusMm));
            }

            return least;
        }
    }

    // Where a straight line first comes within a radius of a segment: of its middle part, or of one of its ends.
    private static double Entry(Point3 place, Vector3 normal, Point3 from, Point3 to, double radius)
    {
        var (along, off) = (to - from, place - from);
        var length = along.Length;
        var axis = along * (1 / length);
        var (n, o) = (normal - (axis * normal.Dot(axis)), off - (axis * off.Dot(axis)));
        var t = Root(n.Dot(n), n.Dot(o), o.Dot(o) - (radius * radius));
        var foot = (off + (normal * t)).Dot(axis);
        var body = foot >= 0 && foot <= length ? t : double.PositiveInfinity;
        var toEnd = place - to;
        return Math.Min(
            body,
            Math.Min(
                Root(1, normal.Dot(off), off.Dot(off) - (radius * radius)),
                Root(1, normal.Dot(toEnd), toEnd.Dot(toEnd) - (radius * radius))));

        // The lower root of a t^2 + 2 b t + c.
        static double Root(double a, double b, double c) =>
            (b * b) - (a * c) is var square && square >= 0 ? (-b - Math.Sqrt(square)) / a : double.PositiveInfinity;
    }

    // The paper's designs, one over skewed parameters, and one with weights.
    private static PartSurface Surface(int number) => number switch
    {
        4 => new(
            "skewed",
            new(
                KnotVector.Clamped(1, [0, 1]),
                KnotVector.Clamped(1, [0, 1]),
                [new(0, 0, 0), new(40, 40, 0), new(50, 0, 1), new(90, 40, 3)]),
            SurfaceRegion.Whole,
            1),
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
