using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceDistanceTests
{
    // A quarter of a cylinder of radius 5 about the Y axis, exactly as a rational quadratic.
    private static readonly SplineSurface Quarter = new(
        new(2, [0, 0, 0, 1, 1, 1]),
        new(1, [0, 0, 1, 1]),
        [new(5, 0, 0), new(5, 9, 0), new(5, 0, 5), new(5, 9, 5), new(0, 0, 5), new(0, 9, 5)],
        [1, 1, Math.Sqrt(0.5), Math.Sqrt(0.5), 1, 1]);

    [Theory]
    [InlineData(0.4, 6, 1)]
    [InlineData(1.2, 4.5, -0.5)]
    [InlineData(0.8, 5.000001, 0.000001)]
    [InlineData(0.1, 0.5, -4.5)]
    public void Distance_from_a_cylinder_is_that_of_the_radii(double angle, double radius, double expected)
    {
        // Du x Dv points inwards here.
        Assert.Equal(-expected, new SurfaceDistance(Quarter).To(new(radius * Math.Cos(angle), 3, radius * Math.Sin(angle))), 1e-10);
    }

    [Fact]
    public void A_point_beside_an_edge_is_measured_across_the_surface_only()
        => Assert.Equal(0.002, Math.Abs(new SurfaceDistance(Quarter).To(new(5.002, -0.01, 0))), 1e-9);

    [Fact]
    public void Mean_and_largest_count_both_sides()
    {
        var summary = new SurfaceDistance(Quarter).Of([new(5.1, 2, 0), new(4.7, 2, 0)]);
        Assert.Equal(0.2, summary.MeanMm, 1e-9);
        Assert.Equal(0.3, summary.MaxMm, 1e-9);
    }
}
