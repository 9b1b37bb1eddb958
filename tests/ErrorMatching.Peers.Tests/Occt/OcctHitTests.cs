using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Places at which lines meet random B-splines against the CAD kernel's.</summary>
public sealed class OcctHitTests
{
    private const int Surfaces = 8;
    private const int Lines = 10;

    [Fact]
    public void Lines_meet_surfaces_where_the_kernel_says()
    {
        OcctDraw.IsNeeded();
        var random = new Random(6);
        var script = new StringBuilder();
        var expected = new List<IReadOnlyList<SurfaceHit>>();
        for (var n = 0; n < Surfaces; n++)
        {
            var surface = RandomSpline.Workpiece(random);
            script.Append(OcctSurface.Command("s", surface));
            for (var i = 0; i < Lines; i++)
            {
                // Through the inside of the surface, every other one flat enough to meet it more than once.
                var through = surface.PointAt(RandomSpline.Inside(random, surface.KnotsU), RandomSpline.Inside(random, surface.KnotsV));
                var direction = new Vector3(
                    random.NextDouble() - 0.5, random.NextDouble() - 0.5, i % 2 == 0 ? 1 : 0.1 * random.NextDouble());
                expected.Add(surface.Hits(through, direction));
                script.Append(
                    CultureInfo.InvariantCulture,
                    $"foreach x [info vars r_*] {{unset $x}}\nline l {Numbers(through.X, through.Y, through.Z)} "
                        + $"{Numbers(direction.X, direction.Y, direction.Z)}\n")
                    .Append("intersect r l s\nset names [info vars r_*]\nif {[llength $names] == 0} {set names r}\nputs \"line 0\"\n")
                    .Append("foreach x $names {coord $x a b c\nputs \"at [dval a] [dval b] [dval c]\"}\n");
            }
        }

        var runs = OcctDraw.Run(script.ToString()).Split("line 0\n").Skip(1).Select(r => OcctSurface.Lines(r, "at")).ToArray();
        Assert.Equal(expected.Count, runs.Length);
        for (var i = 0; i < runs.Length; i++)
        {
            Assert.Equal(runs[i].Length, expected[i].Count);
            Assert.All(expected[i], h => Assert.Contains(runs[i], r => (new Point3(r[0], r[1], r[2]) - h.At.Position).Length < 1e-7));
        }

        Assert.Contains(expected, h => h.Count > 1);
    }

    private static string Numbers(double x, double y, double z) =>
        $"{OcctSurface.Number(x)} {OcctSurface.Number(y)} {OcctSurface.Number(z)}";
}
