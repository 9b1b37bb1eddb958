using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Feet of points on random B-splines against the CAD kernel's.</summary>
public sealed partial class OcctClosestPointTests
{
    private const int Surfaces = 8;
    private const int Places = 12;

    [Fact]
    public void Distances_from_surfaces_are_those_of_the_kernel()
    {
        OcctDraw.IsNeeded();
        var random = new Random(3);
        var script = new StringBuilder();
        var expected = new List<(SplineSurface Surface, SurfaceFoot Foot)>();
        for (var n = 0; n < Surfaces; n++)
        {
            var surface = RandomSpline.Workpiece(random);
            script.Append(OcctSurface.Command("s", surface)).Append("mkface f s\n");
            for (var i = 0; i < Places; i++)
            {
                var p = new Point3((95 * random.NextDouble()) - 10, (83 * random.NextDouble()) - 10, (50 * random.NextDouble()) - 15);
                expected.Add((surface, surface.ClosestPoint(p)));
                var at = $"{OcctSurface.Number(p.X)} {OcctSurface.Number(p.Y)} {OcctSurface.Number(p.Z)}";

                // Distance from the face with its edges; and all feet, for their places.
                script.Append(
                    CultureInfo.InvariantCulture,
                    $"vertex p {at}\ndistmini d p f\nputs \"at [dval d_val]\"\nputs \"feet [string map [list \\n \\;] [proj s {at}]]\"\n");
            }
        }

        var output = OcctDraw.Run(script.ToString());
        var distances = OcctSurface.Lines(output, "at");
        var feet = output.Split('\n').Where(l => l.StartsWith("feet", StringComparison.Ordinal)).ToArray();
        Assert.Equal((expected.Count, expected.Count), (distances.Length, feet.Length));
        var upright = 0;
        for (var i = 0; i < expected.Count; i++)
        {
            var (surface, foot) = expected[i];
            Assert.Equal(distances[i][0], foot.Distance, 1e-9);
            if (foot.OffNormal < 1e-9)
            {
                upright++;
                var nearest = Feet(feet[i]).MinBy(f => (surface.PointAt(f.U, f.V) - foot.At.Position).Length);
                Assert.True((surface.PointAt(nearest.U, nearest.V) - foot.At.Position).Length < 1e-6, $"{foot} is not among {feet[i]}");
            }
        }

        Assert.True(upright > expected.Count / 4, $"only {upright} feet inside");
    }

    [Fact]
    public void Distances_from_curves_are_those_of_the_kernel()
    {
        OcctDraw.IsNeeded();
        var random = new Random(4);
        var script = new StringBuilder();
        var expected = new List<double>();
        for (var n = 0; n < Surfaces; n++)
        {
            var curve = RandomSpline.Curve(random);
            script.Append(OcctSurface.Command("c", curve)).Append("mkedge e c\n");
            for (var i = 0; i < Places; i++)
            {
                var p = new Point3(120 * random.NextDouble(), 120 * random.NextDouble(), 120 * random.NextDouble());
                expected.Add(curve.ClosestPoint(p).Distance);
                script.Append(
                    CultureInfo.InvariantCulture,
                    $"vertex p {OcctSurface.Number(p.X)} {OcctSurface.Number(p.Y)} {OcctSurface.Number(p.Z)}\ndistmini d p e\nputs \"at "
                        + $"[dval d_val]\"\n");
            }
        }

        var distances = OcctSurface.Lines(OcctDraw.Run(script.ToString()), "at");
        Assert.Equal(expected.Count, distances.Length);
        Assert.All(expected.Zip(distances), p => Assert.Equal(p.Second[0], p.First, 1e-9));
    }

    private static IEnumerable<(double U, double V)> Feet(string line) => Parameters().Matches(line)
        .Select(
            m => (
                double.Parse(m.Groups["u"].ValueSpan, CultureInfo.InvariantCulture),
                double.Parse(m.Groups["v"].ValueSpan, CultureInfo.InvariantCulture)));

    [GeneratedRegex("Parameters: (?<u>[-+0-9.e]+) (?<v>[-+0-9.e]+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Parameters();
}
