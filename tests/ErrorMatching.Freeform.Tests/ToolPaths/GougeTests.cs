using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Freeform.Tests;

/// <summary>A ball that does not fit is found, raised or refused.</summary>
public sealed class GougeTests
{
    // The bottom of z = c (x - 10)^2 has the radius 1 / 2c.
    private static double Valley(double c, double x) => c * (x - 10) * (x - 10);

    [Fact]
    public void A_valley_narrower_than_the_ball_is_refused_with_its_place_and_the_ball_that_fits()
    {
        var result = Plans.Of(Shapes.Graph((x, _) => Valley(0.25, x), 20, 4), Plans.Passes(0.01, 0.01));

        Assert.Equal("ball-does-not-fit", result.Refusal?.Code);
        Assert.Contains("v 0", result.Refusal?.Message, StringComparison.Ordinal);
        Assert.Contains(" 4.00 mm", result.Refusal?.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_valley_as_wide_as_the_ball_is_cut()
    {
        var path = Plans.Path(Shapes.Graph((x, _) => Valley(0.16, x), 20, 4), Plans.Passes(0.01, 0.01));

        Assert.Equal(0, path.Certificate.RaisedPoints);
    }

    // A hollow quarter of a cylinder whose radius is smaller than the ball's 3 mm by e:
    // the ball that touches one edge comes within sqrt((3 - e)^2 + e^2) of the other. Twice the chordal error of 0.01 mm may be missing:
    // 0.0189 mm are for e = 0.019, 0.0212 mm for e = 0.0213.
    [Theory]
    [InlineData(0.019, true)]
    [InlineData(0.0213, false)]
    public void A_ball_may_lie_deeper_than_it_touches_by_twice_the_chordal_error(double e, bool isFree)
    {
        var result = Plans.Of(Shapes.Cylinder(3 - e, 4, hollow: true), Plans.Passes(0.001, 0.01, alongU: false));

        Assert.Equal(isFree, result.IsUsable && result.Path.Certificate.RaisedPoints == 0);
        Assert.Equal(isFree ? null : "ball-does-not-fit", result.Refusal?.Code);
    }

    [Fact]
    public void Where_stock_is_left_the_ball_is_raised_until_it_fits()
    {
        // A radius of 2.86 mm at the bottom, but the center runs 3.4 mm from the surface.
        static double Z(double x, double y) => Valley(0.175, x);
        var path = Plans.Path(Shapes.Graph(Z, 20, 4), Plans.Passes(0.01, 0.01), stock: 0.4);

        Assert.True(path.Certificate.RaisedPoints > 0);
        Assert.InRange(path.Certificate.RaisedMm, 0.0001, 0.4);
        Assert.InRange(path.Certificate.RaisedAt.X, 8, 12);
        foreach (var move in path.Moves().Where(m => !m.IsRapid))
        {
            var distance = Graphs.DistanceTo(Z, 20, 4, move.Center);
            Assert.True(distance >= 3.4 - path.Certificate.GougeMm - 0.0001, $"{distance} at {move.Center}");
        }
    }

    [Fact]
    public void A_wall_beside_the_pass_is_found_though_nothing_is_hollow_at_the_foot()
    {
        // Flat up to a wall that rises within half a millimeter: at the flat's end the ball touches the wall, not the foot.
        var knots = KnotVector.Clamped(1, [0, 0.5, 1]);
        Point3[] poles = [new(0, 0, 0), new(0, 5, 0), new(10, 0, 0), new(10, 5, 0), new(10.5, 0, 6), new(10.5, 5, 6)];
        var crease = new PartSurface("wall", new(knots, KnotVector.Clamped(1, [0, 1]), poles), SurfaceRegion.Whole, 1);
        var rounded = new PartSurface(
            "wall",
            new(
                KnotVector.Clamped(2, [0, 0.5, 1]),
                KnotVector.Clamped(1, [0, 1]),
                [.. poles[..4], new(10.2, 0, 0.2), new(10.2, 5, 0.2), .. poles[4..]]),
            SurfaceRegion.Whole,
            1);

        Assert.Equal("edge-in-surface", Plans.Of(crease, Plans.Passes(0.01, 0.01)).Refusal?.Code);
        Assert.Equal("ball-does-not-fit", Plans.Of(rounded, Plans.Passes(0.01, 0.01)).Refusal?.Code);
    }

    [Fact]
    public void A_surface_that_faces_down_is_refused()
    {
        var surface = Shapes.Plane(10, 10) with { Outside = -1 };

        Assert.Equal("faces-down", Plans.Of(surface, Plans.Passes(0.01, 0.01)).Refusal?.Code);
    }

    [Fact]
    public void An_increment_coarser_than_a_tolerance_is_refused() =>
        Assert.Equal(
            "increment-too-coarse",
            Plans.Of(Shapes.Plane(10, 10), Plans.Passes(0.0005, 0.001), dialect: Nc.NcDialects.Siemens840D).Refusal?.Code);

    [Fact]
    public void No_center_comes_nearer_to_any_quadratic_surface_than_its_radius()
    {
        var curvature = Gen.Choose(-40, 40).Select(i => i * 0.002);
        var shapes = curvature.SelectMany(a => curvature.SelectMany(b => curvature.Select(c => (A: a, B: b, C: c))));
        Prop.ForAll(shapes.ToArbitrary(), s =>
        {
            double Z(double x, double y) => (s.A * (x - 6) * (x - 6)) + (s.B * (y - 4) * (y - 4)) + (s.C * (x - 6) * (y - 4));
            var path = Plans.Path(Shapes.Graph(Z, 12, 8), Plans.Passes(0.03, 0.01));
            var moves = path.Moves().ToList();
            foreach (var (from, to) in moves.Zip(moves.Skip(1)).Where((_, i) => i % 7 == 0))
            {
                var middle = from.Center + ((to.Center - from.Center) * 0.5);
                Assert.True(Graphs.DistanceTo(Z, 12, 8, to.Center) >= 3 - path.Certificate.GougeMm - 1e-6);
                Assert.True(Graphs.DistanceTo(Z, 12, 8, middle) >= 3 - path.Certificate.GougeMm - 1e-6);
            }
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(12));
    }
}
