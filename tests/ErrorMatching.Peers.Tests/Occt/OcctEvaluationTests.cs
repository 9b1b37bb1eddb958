using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Points and derivatives of random B-splines against the CAD kernel.</summary>
public sealed class OcctEvaluationTests
{
    private const int Splines = 12;
    private const int Places = 25;
    private const double Tolerance = 1e-10;

    private static readonly string[] Names =
        [
            "x", "y", "z", "dux", "duy", "duz", "dvx", "dvy", "dvz", "d2ux", "d2uy", "d2uz", "d2vx", "d2vy", "d2vz", "d2uvx", "d2uvy",
            "d2uvz"];

    [Fact]
    public void Surfaces_and_their_derivatives_are_those_of_the_kernel()
    {
        OcctDraw.IsNeeded();
        var random = new Random(1);
        var script = new StringBuilder();
        var expected = new List<double[]>();
        for (var n = 0; n < Splines; n++)
        {
            var surface = RandomSpline.Surface(random);
            script.Append(OcctSurface.Command("s", surface));
            for (var i = 0; i < Places; i++)
            {
                var (u, v) = (RandomSpline.Inside(random, surface.KnotsU), RandomSpline.Inside(random, surface.KnotsV));
                script.Append(
                    CultureInfo.InvariantCulture,
                    $"svalue s {OcctSurface.Number(u)} {OcctSurface.Number(v)} {string.Join(' ', Names)}\nputs \"at {Values(Names)}\"\n");
                var at = surface.At(u, v);
                expected.Add(
                    [
                        at.Position.X, at.Position.Y, at.Position.Z, .. Parts(at.Du), .. Parts(at.Dv), .. Parts(at.Duu), .. Parts(at.Dvv),
                        .. Parts(at.Duv)]);
            }
        }

        Compare(expected, OcctSurface.Lines(OcctDraw.Run(script.ToString()), "at"));
    }

    [Fact]
    public void Curves_and_their_derivatives_are_those_of_the_kernel()
    {
        OcctDraw.IsNeeded();
        var random = new Random(2);
        var script = new StringBuilder();
        var expected = new List<double[]>();
        var names = Names[..6];
        for (var n = 0; n < Splines; n++)
        {
            var curve = RandomSpline.Curve(random);
            script.Append(OcctSurface.Command("c", curve));
            for (var i = 0; i < Places; i++)
            {
                var t = RandomSpline.Inside(random, curve.Knots);
                script.Append(
                    CultureInfo.InvariantCulture,
                    $"cvalue c {OcctSurface.Number(t)} {string.Join(' ', names)}\nputs \"at {Values(names)}\"\n");
                var d = new Vector3[2];
                curve.Derivatives(t, d);
                expected.Add([.. Parts(d[0]), .. Parts(d[1])]);
            }
        }

        Compare(expected, OcctSurface.Lines(OcctDraw.Run(script.ToString()), "at"));
    }

    private static void Compare(List<double[]> ours, double[][] theirs)
    {
        Assert.Equal(Splines * Places, theirs.Length);
        for (var i = 0; i < theirs.Length; i++)
        {
            // Derivatives are larger than the piece; their last digits count less.
            var size = Math.Max(100, theirs[i].Max(Math.Abs));
            Assert.All(theirs[i].Zip(ours[i]), p => Assert.Equal(p.First, p.Second, Tolerance * size / 100));
        }
    }

    private static string Values(string[] names) => string.Join(' ', names.Select(n => $"[dval {n}]"));

    private static double[] Parts(Vector3 v) => [v.X, v.Y, v.Z];
}
