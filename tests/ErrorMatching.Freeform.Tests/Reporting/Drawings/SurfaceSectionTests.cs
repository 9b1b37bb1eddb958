using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceSectionTests
{
    // A plane of 30 by 40 mm that rises by 40 mm along u: 50 mm long there.
    private static readonly PartSurface Plane = new(
        "plane",
        new(KnotVector.Clamped(1, [0, 1]), KnotVector.Clamped(1, [0, 1]), [new(0, 0, 0), new(0, 40, 0), new(30, 0, 40), new(30, 40, 40)]),
        SurfaceRegion.Whole,
        1);

    private static readonly ErrorSample[] Samples = [
        Sample(1, 0, 0.5, 0.001), Sample(2, 0.25, 0.5, -0.003), Sample(3, 0.75, 0.504, 0.002), Sample(4, 0.75, 0.6, 0.0029),
        Sample(5, 0.25, 0, 0.001)];

    [Fact]
    public void A_line_along_u_goes_through_the_largest_error_and_is_as_long_as_the_surface()
    {
        var section = new SurfaceSection(Plane, Samples, alongU: true);
        Assert.Equal(50, section.LengthMm, 9);
        Assert.Equal(121, section.Places.Count);
        Assert.Equal(50, section.Places[^1].LengthMm, 9);
        Assert.All(section.Places, p => Assert.Equal((0.5, true), (p.V, p.IsInside)));

        // Points within 1 % of the line, at their places along it.
        Assert.Equal([0, 12.5, 37.5], section.PointsOf(Samples).Select(p => Math.Round(p.LengthMm, 9)));
        Assert.Equal([1, -3, 2], section.PointsOf(Samples).Select(p => Math.Round(p.ValueUm, 9)));
        Assert.StartsWith("Along u through point 2", section.Words, StringComparison.Ordinal);
    }

    [Fact]
    public void A_line_along_v_crosses_it_there()
    {
        var section = new SurfaceSection(Plane, Samples, alongU: false);
        Assert.Equal(40, section.LengthMm, 9);
        Assert.Equal(["Point 5: +1.00 µm", "Point 2: -3.00 µm"], section.PointsOf(Samples).Select(p => p.Title));
    }

    [Fact]
    public void A_hole_is_not_on_the_piece()
    {
        var trimmed = Plane with
        {
            Region = new([
                [new(0, 0), new(1, 0), new(1, 1), new(0, 1)],
                [new(0.4, 0.3), new(0.6, 0.3), new(0.6, 0.7), new(0.4, 0.7)]]),
        };
        var section = new SurfaceSection(trimmed, Samples, alongU: true);
        Assert.All(section.Places.Where(p => p.U is > 0.41 and < 0.59), p => Assert.False(p.IsInside));
        Assert.All(section.Places.Where(p => p.U is (> 0.01 and < 0.39) or (> 0.61 and < 0.99)), p => Assert.True(p.IsInside));
    }

    private static ErrorSample Sample(int point, double u, double v, double error) =>
        new(point, point, 0, u, v, new(30 * u, 40 * v, 40 * u), new(-0.8, 0, 0.6), error);
}
