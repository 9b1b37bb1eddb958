using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>A shop's own finishing program that follows the compensation.</summary>
public sealed class SurfaceDisplacerTests
{
    private static readonly NcDialect Dialect = NcDialects.LinuxCnc;
    private static readonly string Measurement = new('a', 64);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Over_a_plane_each_point_goes_down_by_its_own_error(bool tip)
    {
        var surface = Shapes.Plane(75, 63);
        var toolpath = Plans.Passes(0.05, 0.01, tip: tip);
        var program = Program(surface, toolpath);
        var result = Displace(surface, new Wave(), program, 0.5, tip);

        var (before, after) = (result.Before, NcInterpreter.Run(result.Program, Dialect));
        var cuts = 0;
        for (var i = 1; i < before.Motions.Length; i++)
        {
            var (was, now) = (before.Motions[i].End, after.Motions[i].End);
            var touches = Math.Abs(was.Z - (tip ? 0 : 3)) < 1e-6;
            cuts += touches ? 1 : 0;
            Assert.Equal(was.X, now.X, 1e-9);
            Assert.Equal(was.Y, now.Y, 1e-9);
            Assert.Equal(touches ? was.Z - (0.5 * Wave.Error(was.X, was.Y)) : was.Z, now.Z, touches ? 0.00005 + 1e-9 : 0.011);
        }

        Assert.Equal(cuts, result.OnSurface);
        Assert.True(result.Proof.Holds);
        Assert.InRange(result.LargestMoveMm, 0.0045, 0.01);
    }

    [Theory]
    [InlineData(0.01)]
    [InlineData(-0.01)]
    public void A_constant_error_changes_the_distance_of_every_touching_center_by_just_as_much(double error)
    {
        var surface = Shapes.Three;
        var result = Displace(surface, new ConstantField(error, 0), Program(surface, Plans.Passes(0.05, 0.01, zigzag: false)), 1, false);

        var (before, after) = (result.Before, NcInterpreter.Run(result.Program, Dialect));
        for (var i = 1; i < before.Motions.Length; i += 5)
        {
            var (was, now) = (Graphs.DistanceTo(3, before.Motions[i].End), Graphs.DistanceTo(3, after.Motions[i].End));
            if (before.Motions[i].Kind == MotionKind.Line && was < 3.05)
            {
                Assert.Equal(was - error, now, 0.0001);
            }

            Assert.True(now > 3 - 0.01 - 0.0101, $"{now} at motion {i}");
        }
    }

    [Fact]
    public void Comments_and_what_is_far_from_the_surface_stay_as_they_are()
    {
        var surface = Shapes.Plane(75, 63);
        var program = Program(surface, Plans.Passes(0.5, 0.01));
        var result = Displace(surface, new Wave(), program, 1, false);

        var (was, now) = (Lines(program), Lines(result.Program.Bytes));
        Assert.Equal(was.Length + 1, now.Length);
        Assert.Equal(was[..9], now[1..10]);
        Assert.Equal(was[^3..], now[^3..]);
        Assert.True(result.Proof.UntouchedBytesIdentical);
    }

    [Theory]
    [InlineData("linuxcnc", "G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z3 F500\nX75\nG0 Z20\nM2\n", 0, "(", ")")]
    [InlineData("siemens-840d", "; FINISHING\nG710 G90 G17\nG0 X0 Y10 Z20\nG1 Z3 F500\nX75\nG0 Z20\nM30\n", 0, "; ", "")]
    [InlineData("fanuc", "%\nO1000 (FINISHING)\nG21 G90 G17\nG0 X0. Y10. Z20.\nG1 Z3. F500.\nX75.\nG0 Z20.\nM30\n%\n", 2, "(", ")")]
    public void A_program_tells_what_it_was_made_of_and_is_not_displaced_again(
        string control, string text, int line, string opens, string closes)
    {
        var (program, dialect) = (Encoding.ASCII.GetBytes(text), NcDialects.Named(control));
        var result = SurfaceDisplacer.Displace(
            Shapes.Plane(75, 63), new Wave(), 1, Plans.Ball(6), program, dialect, programsTip: false, Measurement, Nothing).Result!;
        var marker =
            $"{opens}ERRORMATCH MEASUREMENT={Measurement.ToUpperInvariant()} BASE={Convert.ToHexString(SHA256.HashData(program))}{closes}";
        Assert.Equal(marker, Lines(result.Program.Bytes)[line]);
        Assert.Equal(marker, result.Proof.Marker);
        Assert.True(result.Proof is { Holds: true, UntouchedBytesIdentical: true });

        // Of another measurement as well, and if somebody edited the marker: the error that is in it was cut away already.
        foreach (var again in new[]
        {
            result.Program.Bytes,
            Encoding.ASCII.GetBytes(Encoding.ASCII.GetString(result.Program.Bytes.Span).Replace("BASE=", "BASE", StringComparison.Ordinal))
        })
        {
            var refusal = SurfaceDisplacer.Displace(
                Shapes.Plane(75, 63), new Wave(), 1, Plans.Ball(6), again, dialect, programsTip: false, new('b', 64), Nothing).Refusal!;
            Assert.Equal((Marker.AlreadyCompensated, line + 1), (refusal.Code, refusal.Place.Line));
        }
    }

    [Fact]
    public void A_program_that_stays_as_it_is_gets_no_marker()
    {
        var program = "G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z3 F500\nX75\nG0 Z20\nM2\n"u8.ToArray();
        var result = Displace(Shapes.Plane(75, 63), new ConstantField(0, 0), program, 1, false);
        Assert.Null(result.Marker);
        Assert.Equal(program, result.Program.Bytes.ToArray());
    }

    [Fact]
    public void A_program_for_another_control_is_blamed_at_its_first_unknown_code()
    {
        var program = "; FINISHING\nG17 G90 G710\nG54\nS10000 M3\nG0 Z20\nX0 Y10\nG1 Z3 F500\nX75\nG0 Z20\nM30\n"u8.ToArray();
        var refusal = SurfaceDisplacer.Displace(
            Shapes.Plane(75, 63), new Wave(), 1, Plans.Ball(6), program, NcDialects.FanucMill, programsTip: false, Measurement, Nothing)
            .Refusal!;
        Assert.Equal((NcRefusalCodes.UnknownState, 2), (refusal.Code, refusal.Place.Line));
        Assert.Contains("G710", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("fanuc", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Ways_straight_up_and_down_stay_upright()
    {
        var surface = Shapes.Graph((x, _) => 0.5 * x, 20, 10);
        var result = Displace(surface, new ConstantField(0.02, 0), Program(surface, Plans.Passes(0.05, 0.01, zigzag: false)), 1, false);

        var (before, after) = (result.Before, NcInterpreter.Run(result.Program, Dialect));
        var upright = 0;
        for (var i = 1; i < before.Motions.Length; i++)
        {
            var (was, now) = (before.Motions[i], after.Motions[i]);
            if (was.Start.X == was.End.X && was.Start.Y == was.End.Y && was.Start.Z != was.End.Z && was.UnknownStart == AxisSet.None)
            {
                Assert.Equal((now.Start.X, now.Start.Y), (now.End.X, now.End.Y));
                upright += was.Start.X != now.Start.X ? 1 : 0;
            }
        }

        Assert.True(upright > 10);
    }

    [Fact]
    public void An_error_that_bends_between_two_points_is_said()
    {
        var surface = Shapes.Plane(75, 63);
        var result = Displace(surface, new Wave(), "G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z3 F500\nX75\nG0 Z20\nM2\n"u8.ToArray(), 1, false);

        // The wave leaves the straight line between its values at both ends by this, looked for every micrometer of the way.
        var bend = Enumerable.Range(0, 75_001).Max(i => Math.Abs(
            Wave.Error(0.001 * i, 10) - Wave.Error(0, 10) - ((Wave.Error(75, 10) - Wave.Error(0, 10)) * i / 75_000)));
        Assert.Equal(bend, result.LargestMisfitMm, 0.00001);
    }

    [Theory]
    [InlineData("G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z3 F500\nG2 X20 Y10 I10 J0\nG0 Z20\nM2\n", "arc-form")]
    [InlineData("G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z8 F500\nX20\nG0 Z20\nM2\n", "program-off-surface")]
    [InlineData("G21 G90 G17\nG0 X0 Y10 Z20\nG1 Z2.5 F500\nX20\nG0 Z20\nM2\n", "program-in-surface")]
    public void What_cannot_follow_is_refused(string program, string code)
    {
        var result = SurfaceDisplacer.Displace(
            Shapes.Plane(75, 63),
            new Wave(),
            1,
            Plans.Ball(6),
            Encoding.ASCII.GetBytes(program),
            Dialect,
            programsTip: false,
            Measurement,
            Nothing);

        Assert.Equal(code, result.Refusal?.Code);
    }

    [Fact]
    public void Beyond_the_edge_the_edge_counts()
    {
        var result = Displace(
            Shapes.Plane(75, 63), new Wave(), "G21 G90 G17\nG0 X-2 Y10 Z20\nG1 Z3 F500\nX0\nX75\nX77\nG0 Z20\nM2\n"u8.ToArray(), 1, false);

        var after = NcInterpreter.Run(result.Program, Dialect);
        Assert.Equal(3 - Wave.Error(0, 10), after.Motions[1].End.Z, 0.00005);
        Assert.Equal(3 - Wave.Error(75, 10), after.Motions[4].End.Z, 0.00005);
    }

    // On a plane at Z 0, the ball of 6 mm touches with its center at Z 3. Two millimeters lie on the plane.
    [Theory]
    // Down to the material, into it, and through it to the other side.
    [InlineData("G0 X0 Y10 Z20\nG0 Z5\nG1 Z3 F500\nX20\nG0 Z20", null)]
    [InlineData("G0 X0 Y10 Z20\nG0 Z4.9\nG1 Z3 F500\nX20\nG0 Z20", 3)]
    [InlineData("G0 X0 Y10 Z4.9\nG1 Z3 F500\nX20\nG0 Z20", 2)]
    // Over the surface in it, and at its height.
    [InlineData("G0 X0 Y10 Z20\nG1 Z3 F500\nX20\nZ4.9\nG0 X40\nG0 Z20", 6)]
    [InlineData("G0 X0 Y10 Z20\nG1 Z3 F500\nX20\nG0 X40\nG0 Z20", 5)]
    [InlineData("G0 X0 Y10 Z20\nG1 Z3 F500\nX20\nZ5\nG0 X40\nG0 Z20", null)]
    // Out of it aslant, so steeply that the gap grows and not, and from end to end between two places that are free.
    [InlineData("G0 X0 Y10 Z20\nG1 Z3 F500\nX20\nG0 X40 Z20", null)]
    [InlineData("G0 X0 Y10 Z20\nG1 Z3 F500\nX20\nG0 X60 Z4.5\nG0 Z20", 5)]
    [InlineData("G0 X-10 Y10 Z20\nG1 X0 Z3 F500\nX20\nG0 Z20\nG0 X-20 Z9\nG0 X95 Z1\nG0 Z20", 7)]
    // Beside the piece there is nothing.
    [InlineData("G0 X-10 Y10 Z20\nG0 Z-5\nG0 Z20\nX0\nG1 Z3 F500\nX20\nG0 Z20", null)]
    public void A_rapid_move_through_what_lies_on_the_surface_is_refused(string moves, int? line)
    {
        var result = SurfaceDisplacer.Displace(
            Shapes.Plane(75, 63),
            new ConstantField(0.01, 0),
            1,
            Plans.Ball(6),
            Encoding.ASCII.GetBytes($"G21 G90 G17\n{moves}\nM2\n"),
            Dialect,
            programsTip: false,
            Measurement,
            new(2, "stock"));

        Assert.Equal(line is null ? [] : ["rapid-too-low"], result.Refusals.Select(r => r.Code));
        Assert.Equal(line, result.IsUsable ? null : result.Refusal.Place.Line);
    }

    [Fact]
    public void Before_finishing_the_stock_of_the_job_lies_on_the_surface()
    {
        // A stock of 0.2 mm, as much again, and what the caller adds.
        var job = Plans.Job(Plans.Passes(0.5, 0.01), "linuxcnc") with { Stock = new(0.4, 0.2) };
        var program = "G21 G90 G17\nG0 X0 Y10 Z20\nG0 Z3.45\nG1 Z3 F500\nX20\nG0 Z20\nM2\n"u8.ToArray();
        Assert.True(Run(0).IsUsable);
        var refusal = Run(0.1).Refusal!;
        Assert.Equal(("rapid-too-low", 3), (refusal.Code, refusal.Place.Line));
        Assert.Matches(@" 0\.450 mm .* 0\.5 mm ", refusal.Message);

        Outcome<DisplacedProgram> Run(double moreMm) => SurfaceDisplacer.Displace(
            Shapes.Plane(75, 63), new ConstantField(0.01, 0), job, program, Dialect, Measurement, moreMm);
    }

    private static StageMaterial Nothing { get; } = new(0, "nothing");

    private static byte[] Program(PartSurface surface, JobToolpath toolpath) =>
        FinishingProgram.Write(Plans.Path(surface, toolpath), Plans.Job(toolpath, "linuxcnc"), Dialect);

    private static DisplacedProgram Displace(PartSurface surface, ErrorField field, byte[] program, double gain, bool tip)
    {
        var result = SurfaceDisplacer.Displace(surface, field, gain, Plans.Ball(6), program, Dialect, tip, Measurement, Nothing);
        Assert.True(result.IsUsable, result.Refusal?.Message);
        return result.Result;
    }

    private static string[] Lines(ReadOnlyMemory<byte> bytes) => Encoding.ASCII.GetString(bytes.Span).Split('\n');

    // An error over 75 x 63 mm whose place is its parameter.
    private sealed class Wave : ErrorField
    {
        public static double Error(double x, double y) => (0.006 * Math.Sin(x / 20)) + (0.004 * Math.Cos(y / 15));

        public override double At(double u, double v) => Error(75 * u, 63 * v);

        public override double StandardUncertaintyAt(double u, double v) => 0;
    }
}
