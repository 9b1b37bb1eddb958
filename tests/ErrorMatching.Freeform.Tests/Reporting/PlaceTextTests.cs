using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class PlaceTextTests
{
    [Fact]
    public void No_zero_has_a_minus()
    {
        Assert.Equal("X0 Y0 Z-0.001", PlaceText.Words(new(-0.0, -0.0004, -0.0006)));
        Assert.Equal("(0, 1.5, -2)", PlaceText.Triple(new(-1e-9, 1.5, -2)));
        Assert.Equal("X0 Y-0.0004 Z0", PlaceText.Words(new(-0.00004, -0.0004, 0), 4));
    }

    [Fact]
    public void What_is_beyond_any_machine_takes_a_few_digits() =>
        Assert.Equal("(1.234E+300, -1E+9, 999999999.5)", PlaceText.Triple(new(1.234e300, -1e9, 999999999.5)));

    [Fact]
    public void A_point_on_an_axis_that_cannot_be_touched_is_named_without_a_minus()
    {
        // It faces down everywhere, and its first row lies on the y axis but for rounding.
        Point3[] poles = [new(-1e-12, 0, 0), new(-1e-12, 20, 0), new(30, 0, 0), new(30, 20, 0)];
        var surface = new PartSurface(
            "down", new(KnotVector.Clamped(1, [0, 1]), KnotVector.Clamped(1, [0, 1]), poles), SurfaceRegion.Whole, -1);
        var refusals = MeasuringPlanner.Plan(surface, Programs.Plan().Measuring).Refusals;
        Assert.NotEmpty(refusals);
        Assert.All(refusals, r => Assert.DoesNotContain("-0 ", r.Message, StringComparison.Ordinal));
    }
}
