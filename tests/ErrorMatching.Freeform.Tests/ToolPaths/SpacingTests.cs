namespace ErrorMatching.Freeform.Tests;

/// <summary>Distances between passes against closed forms of the ridge between two balls.</summary>
public sealed class SpacingTests
{
    [Theory]
    [InlineData(0.001)]
    [InlineData(0.01)]
    [InlineData(0.1)]
    public void Passes_over_a_plane_are_as_far_apart_as_two_balls_allow(double scallop)
    {
        var path = Plans.Path(Shapes.Plane(20, 30), Plans.Passes(scallop));

        var widest = 2 * Math.Sqrt((2 * 3 * scallop) - (scallop * scallop));
        var fewest = Math.Ceiling(30 / widest) + 1;
        Assert.InRange(path.Passes, fewest, Math.Ceiling(fewest * 1.06));
        Assert.InRange(path.Certificate.ScallopMm, 0.8 * scallop, scallop);
    }

    [Theory]
    [InlineData(20, false)]
    [InlineData(20, true)]
    [InlineData(5, false)]
    [InlineData(4, true)]
    public void Passes_along_a_cylinder_are_as_far_apart_as_its_radius_allows(double radius, bool hollow)
    {
        // Passes run along v, the straight lines of the cylinder, a quarter of its circumference apart from first to last.
        const double Scallop = 0.002;
        var path = Plans.Path(Shapes.Cylinder(radius, 10, hollow), Plans.Passes(Scallop, alongU: false));

        // The ridge stands where two balls of radius 3 meet whose centers lie on a circle of radius r + 3 (r - 3 in a hollow),
        // an angle apart: the law of cosines.
        var (orbit, top) = hollow ? (radius - 3, radius - Scallop) : (radius + 3, radius + Scallop);
        var half = Math.Acos(((orbit * orbit) + (top * top) - 9) / (2 * orbit * top));
        var fewest = (Math.PI / 2 / (2 * half)) + 1;
        Assert.InRange(path.Passes, Math.Floor(fewest), Math.Ceiling(fewest * 1.4));
        Assert.InRange(path.Certificate.ScallopMm, 0.8 * Scallop, Scallop);
    }

    [Fact]
    public void Steps_along_a_circle_are_as_long_as_the_chord_of_the_center_allows()
    {
        // Along u the center runs a quarter of a circle of radius 20 + 3; the sagitta of a step h is r (1 - cos(h / 2r)).
        const double Chord = 0.005;
        var path = Plans.Path(Shapes.Cylinder(20, 1), Plans.Passes(0.05, Chord));

        var step = 2 * 23 * Math.Acos(1 - (Chord / 23));
        var fewest = path.Passes * 23 * (Math.PI / 2) / step;
        Assert.InRange(path.Points, fewest, 1.5 * fewest);
        Assert.InRange(path.Certificate.ChordMm, 0.6 * Chord, Chord);
    }

    [Fact]
    public void The_first_and_the_last_pass_run_along_the_edges()
    {
        var path = Plans.Path(Shapes.Plane(20, 7), Plans.Passes(0.01));

        var cuts = path.Moves().Where(m => m is { IsRapid: false } && m.Center.Z == 3).ToList();
        Assert.Equal((0, 7), (cuts.Min(m => m.Center.Y), cuts.Max(m => m.Center.Y)));
        Assert.Equal((0, 20), (cuts.Min(m => m.Center.X), cuts.Max(m => m.Center.X)));
        Assert.Equal(0, cuts[0].Center.Y);
    }

    [Fact]
    public void Stock_lifts_the_path_along_the_normal()
    {
        var path = Plans.Path(Shapes.Cylinder(20, 2), Plans.Passes(0.05, 0.01), stock: 0.4);

        foreach (var move in path.Moves().Where(m => !m.IsRapid && m.Center.Z < 23.41))
        {
            Assert.InRange(Math.Sqrt((move.Center.X * move.Center.X) + (move.Center.Z * move.Center.Z)), 23.4 - 0.01, 26.41);
        }

        Assert.Equal(0.4, path.StockMm);
    }
}
