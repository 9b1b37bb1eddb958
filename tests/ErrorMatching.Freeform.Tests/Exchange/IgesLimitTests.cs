using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The limits of surfaces in IGES files written by hand, on a flat surface of 60 x 40, where a place is (60 u, 40 v).</summary>
public sealed class IgesLimitTests
{
    [Fact]
    public void A_circle_of_parameters_is_followed_to_a_micrometer()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 60), dependent: true);
        var arc = file.Add(100, "100,0.,0.5,0.5,0.75,0.5,0.75,0.5", dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},{arc},0,1", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        var region = file.Read().Region;
        var loop = Assert.Single(region.Loops);
        for (var i = 0; i < loop.Count; i++)
        {
            var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
            Assert.Equal(0.25, a.DistanceTo(new(0.5, 0.5)), 1e-12);
            Assert.InRange(a.Lerp(b, 0.5).DistanceTo(new(0.5, 0.5)), 0.25 - (0.001 / 60), 0.25);
        }

        Assert.Equal(Math.PI * 15 * 15, 3600 * Math.Abs(RegionLoop.Area(loop)), 0.001 * Math.Tau * 15);
    }

    [Fact]
    public void Lines_and_arcs_joined_are_one_loop()
    {
        // A slot: two lines and two half circles, of which one arc runs round a corner of the parameters.
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 60), dependent: true);
        var bottom = file.Add(110, "110,0.3,0.4,0.,0.7,0.4,0.", dependent: true);
        var right = file.Add(100, "100,0.,0.7,0.5,0.7,0.4,0.7,0.6", dependent: true);
        var top = file.Add(110, "110,0.7,0.6,0.,0.3,0.6,0.", dependent: true);
        var left = file.Add(100, "100,0.,0.3,0.5,0.3,0.6,0.3,0.4", dependent: true);
        var chain = file.Add(102, $"102,4,{bottom},{right},{top},{left}", dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},{chain},0,1", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        var loop = Assert.Single(file.Read().Region.Loops);
        Assert.Equal((0.4 * 0.2) + (Math.PI * 0.01), RegionLoop.Area(loop), 2e-5);
    }

    [Fact]
    public void A_curve_in_space_is_projected_to_the_surface()
    {
        var file = new IgesText("1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,1,4HINCH,1,0.01;");
        var surface = file.Add(128, IgesText.Flat(6, 4), dependent: true);
        var hole = file.Add(100, "100,0.,3.,2.,4.,2.,4.,2.", dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},0,{hole},2", dependent: true);
        file.Add(144, $"144,{surface},0,1,0,{boundary}");
        var read = file.Read();
        Assert.Equal(2, read.Region.Loops.Count);
        Assert.False(read.Region.Contains(0.5, 0.5));
        Assert.True(read.Region.Contains(0.1, 0.1));
        Assert.All(read.Region.Loops[1], q => Assert.Equal(1, new Point2(6 * q.X, 4 * q.Y).DistanceTo(new(3, 2)), 1e-6));
    }

    [Fact]
    public void A_limit_that_is_the_border_leaves_the_surface_whole()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 40), dependent: true);
        var border = file.Add(106, "106,2,5,0.,0.,0.,60.,0.,0.,60.,40.,0.,0.,40.,0.,0.,0.,0.", form: 12, dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},0,{border},2", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        Assert.True(file.Read().Region.IsWhole);
    }

    [Fact]
    public void A_trimmed_surface_without_boundaries_is_whole()
    {
        var file = new IgesText();
        file.Add(144, $"144,{file.Add(128, IgesText.Flat(60, 40), dependent: true)},0,0,0");
        Assert.True(file.Read().Region.IsWhole);
    }

    [Fact]
    public void A_bounded_surface_joins_curves_in_their_sense()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 40), dependent: true);
        var there = file.Add(106, "106,2,3,0.,0.,0.,60.,0.,0.,60.,40.,0.", form: 12, dependent: true);
        var back = file.Add(110, "110,0.,0.,0.,60.,40.,0.", dependent: true);
        var boundary = file.Add(141, $"141,0,1,{surface},2,{there},1,0,{back},2,0", dependent: true);
        file.Add(143, $"143,0,{surface},1,{boundary}");
        var region = file.Read().Region;
        Assert.True(region.Contains(0.7, 0.3));
        Assert.False(region.Contains(0.3, 0.7));
        Assert.Equal(0.5, Math.Abs(RegionLoop.Area(region.Loops[0])), 1e-9);
    }

    [Fact]
    public void A_loop_that_does_not_close_is_refused_with_the_place()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 40), dependent: true);
        var open = file.Add(106, "106,2,4,0.,0.,0.,60.,0.,0.,60.,40.,0.,0.,40.,0.", form: 12, dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},0,{open},2", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("open-loop", error.Code);
        Assert.Contains(" 40 mm at (0, 40, 0)", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_limit_away_from_the_surface_is_refused_with_the_place()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 40), dependent: true);
        var high = file.Add(100, "100,2.,30.,20.,40.,20.,40.,20.", dependent: true);
        var boundary = file.Add(142, $"142,0,{surface},0,{high},2", dependent: true);
        file.Add(144, $"144,{surface},1,0,{boundary}");
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("limit-off-surface", error.Code);
        Assert.Matches(@" 2 mm .*\(40, 20, 2\)", error.Problem);
    }

    [Fact]
    public void A_plane_is_as_large_as_its_closed_curve()
    {
        var file = new IgesText();
        var edge = file.Add(100, "100,5.,30.,20.,40.,20.,40.,20.", dependent: true);
        file.Add(108, $"108,0.,0.,2.,10.,{edge}", form: 1);
        var read = file.Read();
        Assert.Equal(5, read.Spline.PointAt(20, 10).Z, 1e-12);
        var loop = Assert.Single(read.Region.Loops);
        Assert.Equal(Math.PI * 100, Math.Abs(RegionLoop.Area(loop)), 0.001 * Math.Tau * 10);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(-1.2)]
    [InlineData(2)]
    public void An_ellipse_is_followed_in_any_position(double turn)
    {
        // Semi-axes 20 and 10 about (30, 25), turned: ((x c + y s)/20)^2 + ((y c - x s)/10)^2 = 1, written out.
        var (s, c) = Math.SinCos(turn);
        var (a, b, k) = ((c * c / 400) + (s * s / 100), 2 * c * s * ((1 / 400.0) - (1 / 100.0)), (s * s / 400) + (c * c / 100));
        var (d, e) = (-(2 * a * 30) - (b * 25), -(2 * k * 25) - (b * 30));
        var f = (a * 900) + (b * 750) + (k * 625) - 1;
        var (x, y) = (30 + (20 * c), 25 + (20 * s));
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 60), dependent: true);
        var numbers = string.Join(
            ',', new[] { a, b, k, d, e, f, 0, x, y, x, y }.Select(n => n.ToString("R", System.Globalization.CultureInfo.InvariantCulture)));
        var ellipse = file.Add(104, $"104,{numbers}", form: 1, dependent: true);
        file.Add(144, $"144,{surface},1,0,{file.Add(142, $"142,0,{surface},0,{ellipse},2", dependent: true)}");
        var loop = Assert.Single(file.Read().Region.Loops);
        Assert.All(
            loop,
            q => Assert.Equal(
                0, (a * 3600 * q.X * q.X) + (b * 3600 * q.X * q.Y) + (k * 3600 * q.Y * q.Y) + (d * 60 * q.X) + (e * 60 * q.Y) + f, 1e-6));
        Assert.Equal(Math.PI * 200, 3600 * Math.Abs(RegionLoop.Area(loop)), 0.1);
    }

    [Fact]
    public void A_surface_of_revolution_is_round()
    {
        var file = new IgesText();
        var axis = file.Add(110, "110,0.,0.,0.,0.,1.,0.", dependent: true);
        var line = file.Add(110, "110,0.,0.,50.,0.,30.,40.", dependent: true);
        file.Add(120, $"120,{axis},{line},-1.,1.");
        var spline = file.Read().Spline;
        for (var i = 0; i <= 10; i++)
        {
            var p = spline.PointAt(i / 10.0, -0.7);
            Assert.Equal(3 * i, p.Y, 1e-12);
            Assert.Equal(50 - i, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), 1e-12);
        }

        Assert.Equal(50 * Math.Sin(1), Math.Abs(spline.PointAt(0, 1).X), 1e-12);
    }

    [Fact]
    public void A_tabulated_cylinder_moves_its_directrix()
    {
        var file = new IgesText();
        var arc = file.Add(
            100,
            "100,0.,0.,0.,50.,0.,0.,50.",
            dependent: true,
            matrix: file.Add(124, "124,1.,0.,0.,0.,0.,0.,-1.,0.,0.,1.,0.,0.", dependent: true));
        file.Add(122, $"122,{arc},50.,30.,0.");
        var spline = file.Read().Spline;
        var p = spline.PointAt(0.4, 0.5);
        Assert.Equal(15, p.Y, 1e-12);
        Assert.Equal(50, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), 1e-12);
    }

    [Fact]
    public void A_ruled_surface_lies_between_its_rails()
    {
        var file = new IgesText();
        var low = file.Add(110, "110,0.,0.,0.,60.,0.,0.", dependent: true);
        var high = file.Add(
            126, "126,2,2,0,0,1,0,0.,0.,0.,2.,2.,2.,1.,1.,1.,60.,40.,8.,30.,40.,20.,0.,40.,8.,0.,2.,0.,0.,1.", dependent: true);
        file.Add(118, $"118,{low},{high},1,0", form: 1);
        var p = file.Read().Spline.PointAt(0.5, 0.5);
        Assert.Equal(30, p.X, 1e-12);
        Assert.Equal(20, p.Y, 1e-12);
        Assert.Equal(7, p.Z, 1e-12);
    }
}
