using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>We read the files that the CAD kernel writes: surfaces within the digits that it writes, limits as large as its own.</summary>
public sealed class OcctWritesTests
{
    // It writes 10 digits in IGES and 13 in STEP; a knot's last digit moves a point by up to 150 times as much.
    private const double IgesMm = 2e-7;
    private const double StepMm = 1e-9;

    public static TheoryData<bool> Formats => [true, false];

    [Theory]
    [MemberData(nameof(Formats))]
    public void Spline_surfaces_are_those_of_the_kernel(bool step)
    {
        OcctDraw.IsNeeded();
        var random = new Random(5);
        for (var n = 0; n < 6; n++)
        {
            var surface = RandomSpline.Workpiece(random);
            var read = ReadWritten($"{OcctSurface.Command("s", surface)}mkface f s\n", step, out _);
            Assert.True(read.Region.IsWhole);
            for (var i = 0; i < 20; i++)
            {
                var (u, v) = (RandomSpline.Inside(random, surface.KnotsU), RandomSpline.Inside(random, surface.KnotsV));
                Assert.True((read.Spline.PointAt(u, v) - surface.PointAt(u, v)).Length < (step ? StepMm : IgesMm));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_plane_is_read_as_large_as_its_face(bool step)
    {
        OcctDraw.IsNeeded();
        var read = ReadWritten("plane p 5 7 10 0 0.2 1\nmkface f p 0 75 0 63\n", step, out var area);
        Assert.True(read.Region.IsWhole);
        Assert.Equal(75 * 63, area, 1e-6);
        var normal = new Vector3(0, 0.2, 1).Normalize();
        foreach (var p in Grid(read))
        {
            Assert.Equal(0, (p - new Point3(5, 7, 10)).Dot(normal), step ? StepMm : IgesMm);
        }

        Assert.Equal(area, AreaOf(read), 1e-5);
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_cylinder_is_read_as_large_as_its_face(bool step)
    {
        OcctDraw.IsNeeded();
        var read = ReadWritten("cylinder c 0 0 0 0 1 0 50\nmkface f c -1 1 0 63\n", step, out var area);
        Assert.True(read.Region.IsWhole);
        Assert.Equal(2 * 50 * 63, area, 1e-6);
        foreach (var p in Grid(read))
        {
            Assert.Equal(50, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), step ? StepMm : IgesMm);
            Assert.InRange(p.Y, -1e-8, 63 + 1e-8);
        }

        // By bands between the grid's lines: their chords are shorter than the arcs.
        Assert.Equal(area, AreaOf(read), 1e-3 * area);
    }

    // The plane is level in IGES: the kernel writes an ellipse there as a spline that has lost its weights, 0.15 mm off,
    // as it reads it again itself.
    [Theory]
    [InlineData(true, "cylinder c 0 0 0 0 1 0 50\nmkface g c -1 1 0 63\n")]
    [InlineData(false, "cylinder c 0 0 0 0 1 0 50\nmkface g c -1 1 0 63\n")]
    [InlineData(true, "plane p 0 0 40 0.1 0.2 1\nmkface g p -70 70 -70 70\n")]
    [InlineData(false, "plane p 0 0 40 0 0 1\nmkface g p -70 70 -70 70\n")]
    [InlineData(true, "beziersurf s 3 3 -40 0 30 -40 30 40 -40 63 30 0 0 40 0 30 45 0 63 40 40 0 30 40 30 35 40 63 45\nmkface g s\n")]
    [InlineData(false, "beziersurf s 3 3 -40 0 30 -40 30 40 -40 63 30 0 0 40 0 30 45 0 63 40 40 0 30 40 30 35 40 63 45\nmkface g s\n")]
    public void A_face_with_a_drilled_hole_and_a_cut_side_has_the_kernels_area(bool step, string face)
    {
        OcctDraw.IsNeeded();
        var read = ReadWritten(
            $"{face}pcylinder d 8 200\nttranslate d 5 30 -50\nbox b -100 -100 -100 70 300 300\nbcut h g d\nbcut k h b\nexplode k "
                + $"f\nrenamevar k_1 f\n",
            step,
            out var area);
        Assert.Equal(2, read.Region.Loops.Count);
        Assert.Equal(area, AreaOf(read), 2e-3 * area);

        // What is inside: nothing in the hole, nothing on the side that was cut off.
        var found = 0;
        foreach (var (u, v) in Inside(read, 80))
        {
            var p = read.Spline.PointAt(u, v);
            found++;
            Assert.True(Math.Sqrt(((p.X - 5) * (p.X - 5)) + ((p.Y - 30) * (p.Y - 30))) > 8 - 0.01, $"{p} is in the hole");
            Assert.True(p.X > -30 - 0.01, $"{p} was cut off");
        }

        Assert.True(found > 1000);
    }

    // Builds a face f in DRAW, writes it, reads what was written with ours.
    private static PartSurface ReadWritten(string script, bool step, out double area)
    {
        var write = step ? "stepwrite a f w.stp\nset h [open w.stp]" : "brepiges f w.igs\nset h [open w.igs]";
        var output = OcctDraw.Run(
            $"{script}set p [sprops f 1e-9]\nregexp {{Mass :\\s+([-0-9.e+]+)}} $p all mass\nputs \"area $mass\"\n{write}\nputs "
                + $"\"<<<[read $h]>>>\"\n");
        area = Math.Abs(OcctSurface.Lines(output, "area")[0][0]);
        var (from, to) = (output.IndexOf("<<<", StringComparison.Ordinal) + 3, output.IndexOf(">>>", StringComparison.Ordinal));
        return SurfaceReader.Read(Encoding.ASCII.GetBytes(output[from..to]), step ? "w.stp" : "w.igs", entity: null, outsideIsUp: true);
    }

    private static IEnumerable<Point3> Grid(PartSurface surface) => Inside(surface, 20).Select(q => surface.Spline.PointAt(q.U, q.V));

    private static IEnumerable<(double U, double V)> Inside(PartSurface surface, int steps)
    {
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        return from i in Enumerable.Range(0, steps)
               from j in Enumerable.Range(0, steps)
               let a = u.Start + ((u.End - u.Start) * (i + 0.5) / steps)
               let b = v.Start + ((v.End - v.Start) * (j + 0.5) / steps)
               where surface.Region.Contains(a, b)
               select (a, b);
    }

    // Sum of the elements of area at the middles of small cells.
    private static double AreaOf(PartSurface surface)
    {
        const int Steps = 400;
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        var cell = (u.End - u.Start) * (v.End - v.Start) / Steps / Steps;
        return Inside(surface, Steps).Sum(q => surface.Spline.At(q.U, q.V) is var at ? at.Du.Cross(at.Dv).Length * cell : 0);
    }
}
