using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Knots, degrees and poles of changed surfaces against those that the CAD kernel makes of the same ones.</summary>
public sealed class OcctChangesTests
{
    private const int Surfaces = 10;

    // The kernel writes 15 digits.
    private const double Tolerance = 1e-11;

    [Fact]
    public void Inserted_knots_raised_degrees_and_parts_have_the_poles_of_the_kernel()
    {
        OcctDraw.IsNeeded();
        var random = new Random(5);
        var script = new StringBuilder();
        var expected = new List<SplineSurface>();
        for (var n = 0; n < Surfaces; n++)
        {
            var surface = RandomSpline.Workpiece(random);
            var (u, v) = (RandomSpline.Inside(random, surface.KnotsU), RandomSpline.Inside(random, surface.KnotsV));
            var (degreeU, degreeV) = (surface.KnotsU.Degree + 1 + random.Next(2), surface.KnotsV.Degree + 1);
            script.Append(OcctSurface.Command("s", surface))
                .Append(
                    CultureInfo.InvariantCulture,
                    $"insertuknot s {OcctSurface.Number(u)} 2\ninsertvknot s {OcctSurface.Number(v)} 1\n{Print("inserted")}")
                .Append(CultureInfo.InvariantCulture, $"incudeg s {degreeU}\nincvdeg s {degreeV}\n{Print("raised")}")
                .Append(
                    CultureInfo.InvariantCulture,
                    $"segsur s {OcctSurface.Number(u)} {OcctSurface.Number(surface.KnotsU.End)} "
                        + $"{OcctSurface.Number(surface.KnotsV.Start)} {OcctSurface.Number(v)}\n{Print("part")}")
                .Append(CultureInfo.InvariantCulture, $"exchuv s\n{Print("exchanged")}");
            var inserted = surface.InsertKnotU(u, 2).InsertKnotV(v);
            var raised = inserted.ElevateTo(degreeU, degreeV);
            var part = raised.Between(u, surface.KnotsU.End, surface.KnotsV.Start, v);
            expected.AddRange([inserted, raised, part, part.Swap()]);
        }

        var written = OcctDraw.Run(script.ToString()).Split("DrawTrSurf_BSplineSurface\n").Skip(1).ToArray();
        Assert.Equal(expected.Count, written.Length);
        for (var i = 0; i < written.Length; i++)
        {
            Compare(expected[i], written[i]);
        }
    }

    private static string Print(string name) => $"save s {name}\nset f [open {name}]\nputs [read $f]\nclose $f\n";

    // Kind, rational twice, periodic twice, degrees, poles and knots in each direction; then poles, v running faster, each with its weight
    // if rational; then knots with how often they count.
    private static void Compare(SplineSurface ours, string written)
    {
        var numbers = written.Split((char[])[' ', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries);
        double Number(int i) => double.Parse(numbers[i], CultureInfo.InvariantCulture);
        Assert.Equal(
            [ours.KnotsU.Degree, ours.KnotsV.Degree, ours.CountU, ours.CountV],
            Enumerable.Range(5, 4).Select(i => (int)Number(i)).ToArray());
        var rational = Number(1) != 0 || Number(2) != 0;
        var size = rational ? 4 : 3;
        for (var i = 0; i < ours.Poles.Length; i++)
        {
            var at = 11 + (i * size);
            Assert.True(
                (ours.Poles[i] - new Point3(Number(at), Number(at + 1), Number(at + 2))).Length < Tolerance,
                $"pole {i}: {ours.Poles[i]} is not {numbers[at]} {numbers[at + 1]} {numbers[at + 2]}");
            if (rational)
            {
                Assert.Equal(Number(at + 3), ours.Weights[i], 1e-12);
            }
        }

        var next = 11 + (ours.Poles.Length * size);
        foreach (var knots in new[] { ours.KnotsU, ours.KnotsV })
        {
            foreach (var value in knots.Breaks)
            {
                Assert.Equal(Number(next), value, 1e-12);
                Assert.Equal((int)Number(next + 1), knots.Multiplicity(value));
                next += 2;
            }
        }
    }
}
