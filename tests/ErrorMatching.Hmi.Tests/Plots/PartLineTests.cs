using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi.Tests;

public sealed class PartLineTests
{
    [Fact]
    public void A_place_is_found_by_length_and_not_by_the_number_of_points()
    {
        var line = new PartLine("L1", [("1", new(0, 0)), ("2", new(1, 0)), ("2a", new(1, 0)), ("3", new(1, 9))]);
        Assert.Equal(new Point2(1, 4), line.At(0.5));
        Assert.Equal(new Point2(0.5, 0), line.At(0.05));
        Assert.Equal((new Point2(0, 0), new Point2(1, 9)), (line.At(0), line.At(1)));
    }

    [Fact]
    public void A_line_of_one_place_has_that_and_one_of_none_has_none()
    {
        Assert.Equal(new Point2(3, 4), new PartLine("P", [("1", new(3, 4))]).At(0.5));
        Assert.Equal(new Point2(3, 4), new PartLine("P", [("1", new(3, 4)), ("2", new(3, 4))]).At(0.5));
        Assert.Throws<InvalidOperationException>(() => new PartLine("P", []).At(0.5));
    }
}
