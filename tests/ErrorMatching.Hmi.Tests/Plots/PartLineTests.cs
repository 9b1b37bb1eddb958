using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi.Tests;

public sealed class PartLineTests
{
    [Fact]
    public void A_place_is_found_by_length_and_not_by_the_number_of_points()
    {
        var line = Line(new(0, 0), new(1, 0), new(1, 0), new(1, 9));
        Assert.Equal(new Point2(1, 4), line.At(0.5));
        Assert.Equal(new Point2(0.5, 0), line.At(0.05));
        Assert.Equal((new Point2(0, 0), new Point2(1, 9)), (line.At(0), line.At(1)));
    }

    [Fact]
    public void A_line_of_one_place_has_that_and_one_of_none_has_none()
    {
        Assert.Equal(new Point2(3, 4), Line(new Point2(3, 4)).At(0.5));
        Assert.Equal(new Point2(3, 4), Line(new(3, 4), new(3, 4)).At(0.5));
        Assert.Throws<InvalidOperationException>(() => Line().At(0.5));
    }

    private static PartLine Line(params Point2[] outline) => new("L1", [.. outline.Select((p, i) => ($"{i}", p))], outline);
}
