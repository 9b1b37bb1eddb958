using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Limits in space on surfaces that close on themselves: a cylinder of radius 15 about the y axis, 50 mm long, whose seam lies on
/// top (x = 0, z = 15). Angles are counted from x to z.</summary>
public sealed class SeamTests
{
    private const double Radius = 15;
    private const double Length = 50;

    public static TheoryData<string> Kinds => ["spline", "revolution"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_limit_along_the_seam_stays_on_its_side(string kind)
    {
        Assert.Equal(Radius * Math.PI / 2 * Length, Area(Patch(kind, 90, 0)), 0.05);
        Assert.Equal(Radius * Math.PI / 4 * Length, Area(Patch(kind, 90, 135)), 0.05);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_limit_that_only_touches_the_seam_stays_on_its_side(string kind)
    {
        Assert.Equal(Radius * Math.PI / 2 * Length, Area(Patch(kind, 0, 90)), 0.05);
        Assert.Equal(Radius * Math.PI / 4 * Length, Area(Patch(kind, 135, 90)), 0.05);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_limit_across_the_seam_is_refused(string kind)
    {
        var error = Assert.Throws<InputException>(() => Patch(kind, 150, 30));
        Assert.Equal("bad-loop", error.Code);
        Assert.Contains("cross the line where the surface closes on itself", error.Problem, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_limit_round_the_surface_is_refused(string kind)
    {
        var file = new IgesText();
        var error = Assert.Throws<InputException>(() => Limited(file, kind, [Arc(file, 20, 90, 90)]));
        Assert.Equal("bad-loop", error.Code);
        Assert.Contains(" (0, 20, 15) ", error.Problem, StringComparison.Ordinal);
    }

    // The part between two angles, begun with the line at the first one.
    private static PartSurface Patch(string kind, double from, double to)
    {
        var file = new IgesText();
        return Limited(
            file, kind, [Line(file, from, 0, Length), Arc(file, Length, from, to), Line(file, to, Length, 0), Arc(file, 0, to, from)]);
    }

    private static PartSurface Limited(IgesText file, string kind, int[] curves)
    {
        var surface = kind == "spline"
            ? file.Add(128, Spline(), dependent: true)
            : file.Add(
                120,
                $"120,{file.Add(110, "110,0.,0.,0.,0.,1.,0.", dependent: true)},{Line(file, 90, 0, Length)},0.,{Text(Math.Tau)}",
                dependent: true);
        var chain = file.Add(102, $"102,{curves.Length},{string.Join(',', curves)}", dependent: true);
        file.Add(144, $"144,{surface},1,0,{file.Add(142, $"142,0,{surface},0,{chain},2", dependent: true)}");
        return file.Read();
    }

    // Nine poles round, the corners of a square between its middles, at either end.
    private static string Spline()
    {
        var weights = string.Concat(Enumerable.Repeat(
            string.Concat(Enumerable.Range(0, 9).Select(i => "," + Text(i % 2 == 0 ? 1 : Math.Sqrt(0.5)))), 2));
        var poles = string.Concat(new[] { 0, Length }.SelectMany(
            y => Enumerable.Range(0, 9).Select(i => $",{Text(Radius * Sign(i))},{Text(y)},{Text(Radius * Sign(i + 2))}")));
        return $"128,8,1,2,1,1,0,0,0,0,0.,0.,0.,1.,1.,2.,2.,3.,3.,4.,4.,4.,0.,0.,50.,50.{weights}{poles},0.,4.,0.,50.";
    }

    // 0, 1, 1, 1, 0, -1, -1, -1, and again.
    private static int Sign(int i) => Math.Sign(i % 4) * (i % 8 < 4 ? 1 : -1);

    private static int Line(IgesText file, double angle, double from, double to)
    {
        var (x, z) = At(angle);
        return file.Add(110, $"110,{x},{Text(from)},{z},{x},{Text(to)},{z}", dependent: true);
    }

    // An arc runs counter-clockwise in a plane of its own: x, z, -y where angles rise, -x, z, y where they fall.
    private static int Arc(IgesText file, double y, double from, double to)
    {
        var side = to > from ? 1 : -1;
        var matrix = file.Add(124, $"124,{side}.,0.,0.,0.,0.,0.,{-side}.,0.,0.,1.,0.,0.", dependent: true);
        var ((x0, z0), (x1, z1)) = (At(side > 0 ? from : 180 - from), At(side > 0 ? to : 180 - to));
        return file.Add(100, $"100,{Text(-side * y)},0.,0.,{x0},{z0},{x1},{z1}", dependent: true, matrix: matrix);
    }

    private static (string X, string Z) At(double angle) =>
        (Text(Radius * Math.Cos(angle * Math.PI / 180)), Text(Radius * Math.Sin(angle * Math.PI / 180)));

    private static string Text(double value) => value.ToString("0.0##############", CultureInfo.InvariantCulture);

    // The area in space of what the limits enclose, by midpoints.
    private static double Area(PartSurface surface)
    {
        const int Many = 200;
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        var (du, dv) = ((u.End - u.Start) / Many, (v.End - v.Start) / Many);
        var sum = 0.0;
        for (var i = 0; i < Many; i++)
        {
            for (var j = 0; j < Many; j++)
            {
                var (a, b) = (u.Start + ((i + 0.5) * du), v.Start + ((j + 0.5) * dv));
                if (surface.Region.Contains(a, b))
                {
                    var at = surface.Spline.At(a, b);
                    sum += at.Du.Cross(at.Dv).Length * du * dv;
                }
            }
        }

        return sum;
    }
}
