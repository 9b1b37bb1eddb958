using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Center words: how far the radii of an arc may differ for the sake of its middle, and when the old words stay.</summary>
public sealed class CenterGridTests
{
    private static readonly Arc2 Quarter = new(new(0, 0), 10, Angle.FromDegrees(0), Angle.FromDegrees(90));

    // The radii from (0, 0) differ by 0.4 or by 0.8 of the increment of 0.0001. Half of it is free.
    // Beyond that a center that is an increment off and sees both ends alike is better:
    // (-0.0001, 0), from where the radii are 10.0001 and 10.00008.
    [Theory]
    [InlineData(10.00004, 0)]
    [InlineData(10.00008, -1)]
    public void Radii_may_differ_by_half_an_increment(double end, long first)
    {
        var found = CenterGrid.Choose(Point2.Origin, new(10, 0), new(0, end), Quarter, null, 0.0001);

        Assert.Equal((first, 0), (found.First!.Value, found.Second!.Value));
    }

    // The grid of 0.01 has no better center. A control accepts radii that differ by 0.001 mm.
    [Theory]
    [InlineData(10.00099, true)]
    [InlineData(10.00101, false)]
    public void Old_words_stay_as_long_as_every_control_accepts_them(double end, bool stay)
    {
        var found = CenterGrid.Choose(Point2.Origin, new(10, 0), new(0, end), Quarter, Vector2.Zero, 0.01);

        Assert.Equal(stay ? (null, null) : (0L, 0L), found);
    }

    // 300 degrees about a center that lies beside the grid. From (0, -0.001) the radii agree to 0.00006 mm,
    // but the middle lies 0.0013 mm off; from (0, 0) they differ by 0.0007 mm, and the middle lies where it is wanted to 0.0001 mm.
    [Fact]
    public void Beyond_half_a_turn_the_middle_is_worth_radii_that_differ_a_little()
    {
        var arc = new Arc2(new(-0.0000423, -0.0002221), 2, Angle.FromDegrees(340), Angle.FromDegrees(300));
        var found = CenterGrid.Choose(Point2.Origin, new(1.879, -0.684), new(0.347, -1.97), arc, null, 0.001);

        Assert.Equal((0, 0), (found.First!.Value, found.Second!.Value));
    }
}
