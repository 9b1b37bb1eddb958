using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

public sealed class MeasuredPointTests
{
    // The drawing is flat, the gauge reports heights: an origin 7 mm high is where it belongs.
    [Fact]
    public void An_origin_is_not_off_by_a_height_that_one_file_does_not_have() =>
        Assert.Equal(0.005, OriginCheck.Check(new("O", 0.013), new("O", new(0, 0, 0), HasZ: false, 1), At(0.003, 0.004, 7)).DistanceMm, 12);

    [Fact]
    public void The_ball_lies_in_the_air_of_the_piece_that_it_measures()
    {
        // The boundary is the line x = 5: the counterpart's material at x < 5, its tool and later the part's material at x > 5.
        // The normal points to +x.
        var normal = new Vector2(1, 0);

        // A ball of radius 1 that touches the part at x = 5 has its center at x = 4, where the part has air.
        Assert.Equal(new(5, 7), StylusCenter.ToContact(new(4, 7), 1, normal, MeasuredPiece.Part));

        // A ball that touches the counterpart at x = 5 has its center at x = 6, where the tool was.
        Assert.Equal(new(5, 7), StylusCenter.ToContact(new(6, 7), 1, normal, MeasuredPiece.Counterpart));
    }

    [Fact]
    public void An_origin_within_its_limit_holds()
    {
        var check = OriginCheck.Check(new("O", 0.013), At(0, 0, 0), At(0.003, 0.004, 0.012));

        Assert.Equal(0.013, check.DistanceMm, 12);
        Assert.Null((check with { DistanceMm = 0.013 }).Refusal);
    }

    [Fact]
    public void An_origin_that_is_off_refuses_the_job()
    {
        var check = OriginCheck.Check(new("O", 0.01), At(1, 1, 0), At(1, 1.02, 0));

        Assert.False(check.Holds);
        Assert.Equal(("origin-off", "O"), (check.Refusal!.Code, check.Refusal.Place.Point));
        Assert.Contains("0.020 mm off, more than the 0.01 mm allowed", check.Refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(CoordinatePlane.XY, 1, 2, 3)]
    [InlineData(CoordinatePlane.ZX, 3, 1, 2)]
    [InlineData(CoordinatePlane.YZ, 2, 3, 1)]
    public void Points_in_space_are_projected_to_the_plane_of_their_feature(
        CoordinatePlane plane, double first, double second, double height)
    {
        var point = ProjectedPoint.Of(new("1", new(1, 2, 3), true, 2), plane, "part.csv");
        var theoretical = point with { HeightMm = height - 0.25 };

        Assert.Equal((new Point2(first, second), height), (point.Position, point.HeightMm));
        Assert.Equal(0.25, point.StandsOutMm(theoretical));
    }

    [Fact]
    public void Points_without_z_lie_in_xy_only()
    {
        var flat = new LabelledPoint("1", new(1, 2, 0), false, 7);

        Assert.Null(ProjectedPoint.Of(flat, CoordinatePlane.XY, "part.csv").StandsOutMm(new("1", default, 3)));
        var e = Assert.Throws<InputException>(() => ProjectedPoint.Of(flat, CoordinatePlane.ZX, "part.csv"));
        Assert.Equal(("missing-coordinate", "part.csv", 7), (e.Code, e.File, e.Place.Line));
    }

    private static LabelledPoint At(double x, double y, double z) => new("O", new(x, y, z), HasZ: true, 1);
}
