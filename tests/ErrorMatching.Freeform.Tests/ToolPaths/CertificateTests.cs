using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What a path certifies, against spheres laid along it and against the closed form of the surface.</summary>
public sealed class CertificateTests
{
    private const double Micrometer = 0.001;

    [Theory]
    [InlineData(1, "siemens-840d", true)]
    [InlineData(2, "siemens-840d", false)]
    [InlineData(3, "siemens-840d", true)]
    [InlineData(3, "linuxcnc", true)]
    public void Spheres_along_the_path_leave_no_more_than_is_certified(int design, string dialect, bool alongU)
    {
        var surface = Shapes.Design(design);
        var path = Plans.Path(surface, Plans.Passes(Micrometer, Micrometer, alongU), dialect: NcDialects.Named(dialect));

        var ball = new VirtualBall(3, path.Moves());
        var random = new Random(design);
        var (highest, deepest) = (double.NegativeInfinity, double.PositiveInfinity);
        for (var i = 0; i < 1500; i++)
        {
            var (place, normal) = On(surface, random.NextDouble(), random.NextDouble());
            var left = ball.Left(place, normal);
            (highest, deepest) = (Math.Max(highest, left), Math.Min(deepest, left));
        }

        // The spheres stand 0.02 mm apart: they leave 0.00002 mm more than the ball.
        Assert.InRange(path.Certificate.ScallopMm, 0, Micrometer);
        Assert.InRange(path.Certificate.ChordMm, 0, Micrometer);
        Assert.True(highest <= path.Certificate.ScallopMm + 0.00002, $"{highest} mm are left, {path.Certificate.ScallopMm} certified");
        Assert.True(highest > 0.7 * Micrometer, $"only {highest} mm are left: passes are closer than they need be");
        Assert.True(deepest >= -path.Certificate.ChordMm - 0.00002, $"{-deepest} mm too deep, {path.Certificate.ChordMm} certified");
    }

    [Theory]
    [InlineData(1, 30_000, 45_000)]
    [InlineData(2, 5_000, 10_000)]
    [InlineData(3, 30_000, 45_000)]
    public void The_paper_s_designs_take_about_as_many_points_as_in_the_paper(int design, int fewest, int most)
    {
        var path = Plans.Path(Shapes.Design(design), Plans.Passes(Micrometer, Micrometer));

        Assert.InRange(path.Points, fewest, most);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Every_center_of_a_pass_lies_on_the_exact_offset(int design)
    {
        // Solved for by itself: the foot of a center on the graph, by Newton's method on its closed form.
        var surface = Shapes.Design(design);
        var path = Plans.Path(surface, Plans.Passes(0.01, 0.01));

        var high = path.TravelCenterZ;
        foreach (var move in path.Moves().Where(m => !m.IsRapid && m.Center.Z < high - 5).Take(3000))
        {
            var distance = Graphs.DistanceTo(design, move.Center);
            Assert.True(distance > 3 - 0.01, $"{distance} at {move.Center}");
        }
    }

    [Fact]
    public void A_path_too_long_to_be_kept_is_made_again_as_it_was_measured()
    {
        var path = Plans.Path(Shapes.One, Plans.Passes(0.0002, 0.0002));
        var (cut, from) = (0.0, default(Point3));
        foreach (var move in path.Moves())
        {
            cut += move.IsRapid ? 0 : (move.Center - from).Length;
            from = move.Center;
        }

        Assert.True(path.Points > 150_000, $"{path.Points} points");
        // The way in and the way out are each as long as the ball's radius.
        Assert.Equal(path.LengthMm + 6, cut, 0.001);
    }

    [Fact]
    public void A_path_is_the_same_each_time_its_moves_are_asked_for()
    {
        var path = Plans.Path(Shapes.Three, Plans.Passes(0.02, 0.01));

        Assert.Equal(path.Moves(), path.Moves());
        Assert.Equal(path.Moves(), Plans.Path(Shapes.Three, Plans.Passes(0.02, 0.01)).Moves());
    }

    private static (Point3 Place, Vector3 Normal) On(PartSurface surface, double u, double v) =>
        (surface.Spline.PointAt(u, v), surface.NormalAt(u, v));
}
