using System.Globalization;
using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Freeform.Tests;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>The CAD kernel reads the files that we write: one valid face, its surface within 1 nm.</summary>
public sealed class OcctReadsTests
{
    private const double Nanometer = 1e-6;
    private const int Places = 20;

    public static TheoryData<bool> Formats => [true, false];

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_written_surface_is_the_same_to_a_nanometer(bool step)
    {
        OcctDraw.IsNeeded();
        PartSurface[] surfaces = [
            PaperDesign.One,
            PaperDesign.Two,
            PaperDesign.Three,
            PaperDesign.Three with { Spline = PaperDesign.Three.Spline.Swap(), Outside = -1 },
            .. Enumerable.Range(1, 10).Select(n => SurfaceSamples.Of(n)),
            .. Enumerable.Range(11, 6).Select(n => SurfaceSamples.Of(n, limited: true))];
        var random = new Random(1);
        var script = new StringBuilder();
        var expected = new List<Point3>();
        for (var n = 0; n < surfaces.Length; n++)
        {
            var spline = surfaces[n].Spline;
            script.Append(
                CultureInfo.InvariantCulture,
                $"{ReadCommand(n, step)}\nmksurface s f{n}\nset c [checkshape r{n}]\nputs \"valid [string match *valid* $c]\"\n");
            for (var i = 0; i < Places; i++)
            {
                var (u, v) = (RandomSpline.Inside(random, spline.KnotsU), RandomSpline.Inside(random, spline.KnotsV));
                script.Append($"svalue s {OcctSurface.Number(u)} {OcctSurface.Number(v)} x y z\nputs \"at [dval x] [dval y] [dval z]\"\n");
                expected.Add(spline.PointAt(u, v));
            }
        }

        var output = OcctDraw.Run(
            script.ToString(),
            [
                .. surfaces.Select(
                    (s, n) => (
                        $"{n}{(step ? ".stp" : ".igs")}", Encoding.ASCII.GetString(step ? StepWriter.Write(s) : IgesWriter.Write(s))))]);
        var points = OcctSurface.Lines(output, "at");
        Assert.Equal(expected.Count, points.Length);
        Assert.All(points.Zip(expected), p => Assert.True((new Point3(p.First[0], p.First[1], p.First[2]) - p.Second).Length < Nanometer));
        Assert.Equal(Enumerable.Repeat(1.0, surfaces.Length), OcctSurface.Lines(output, "valid").Select(l => l[0]));
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_written_limit_encloses_the_same_area(bool step)
    {
        OcctDraw.IsNeeded();

        // A flat piece of 60 x 40 with a corner cut off and a rectangular hole: 2400 - 10 * 8 / 2 - 12 * 10.
        Point3[] poles = [new(0, 0, 5), new(0, 40, 5), new(60, 0, 5), new(60, 40, 5)];
        var knots = KnotVector.Clamped(1, [0, 1]);
        IReadOnlyList<Point2>[] loops = [
            [new(0, 0), new(50 / 60.0, 0), new(1, 8 / 40.0), new(1, 1), new(0, 1)],
            [new(0.2, 0.25), new(0.2, 0.5), new(0.4, 0.5), new(0.4, 0.25)]];
        var surface = new PartSurface("PLATE", new(knots, knots, poles), new(loops), 1);
        var text = Encoding.ASCII.GetString(step ? StepWriter.Write(surface) : IgesWriter.Write(surface));
        var output = OcctDraw.Run(
            $"{ReadCommand(0, step)}\nset p [sprops r0 1e-9]\nregexp {{Mass :\\s+([-0-9.e+]+)}} $p all mass\nputs \"area $mass\"\n",
            (step ? "0.stp" : "0.igs", text));
        Assert.Equal(2400 - 40 - 120, OcctSurface.Lines(output, "area")[0][0], 1e-6);
    }

    // The surface is z = x² / 100: its element of area is sqrt(1 + (x/50)²), the integral of which is 25 (s sqrt(1 + s²) + asinh s) with s
    // = x / 50.
    [Theory]
    [MemberData(nameof(Formats))]
    public void A_written_limit_of_few_corners_lies_on_a_curved_surface(bool step)
    {
        OcctDraw.IsNeeded();
        Point3[] poles = [new(0, 0, 0), new(0, 40, 0), new(30, 0, 0), new(30, 40, 0), new(60, 0, 36), new(60, 40, 36)];
        IReadOnlyList<Point2>[] loops = [[new(0.1, 0.25), new(0.9, 0.25), new(0.9, 0.75), new(0.1, 0.75)]];
        var surface = new PartSurface("TROUGH", new(KnotVector.Clamped(2, [0, 1]), KnotVector.Clamped(1, [0, 1]), poles), new(loops), 1);
        var text = Encoding.ASCII.GetString(step ? StepWriter.Write(surface) : IgesWriter.Write(surface));
        var output = OcctDraw.Run(
            $"{ReadCommand(0, step)}\nset p [sprops r0 1e-9]\nregexp {{Mass :\\s+([-0-9.e+]+)}} $p all mass\nputs \"area $mass\"\nregexp "
                + $"{{EDGE\\s+: MAX=([-0-9.e+]+)}} [tolerance r0] all most\nputs \"off $most\"\n",
            (step ? "0.stp" : "0.igs", text));
        Assert.Equal(20 * (Integral(54) - Integral(6)), OcctSurface.Lines(output, "area")[0][0], 0.01);
        Assert.InRange(OcctSurface.Lines(output, "off")[0][0], 0, 0.0015);

        static double Integral(double x) => 25 * ((x / 50 * Math.Sqrt(1 + (x * x / 2500))) + Math.Asinh(x / 50));
    }

    // The whole shape as r, its face as f: a face by itself from IGES, a shell from STEP.
    private static string ReadCommand(int n, bool step) => step
        ? $"stepread {n}.stp t{n} *\nrenamevar t{n}_1 r{n}\nexplode r{n} f\nrenamevar r{n}_1 f{n}"
        : $"igesbrep {n}.igs r{n} *\ncopy r{n} f{n}";
}
