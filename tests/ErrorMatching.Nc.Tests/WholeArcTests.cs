using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>An arc that is displaced, or that follows what is displaced beside it, moves nowhere by more than was asked: not at its ends
/// and not between them. The tests measure arcs by their start, end and center alone, at a thousand places.</summary>
public sealed class WholeArcTests
{
    private const double Increment = 0.001;

    // Both coordinates of the ends and of the center are rounded.
    private const double Rounding = 1.6 * Increment;

    private const string Slot =
        "G90 G17 G54\nG0 X-20 Y-5 Z1\nN1 G1 X20 F150\nN2 G3 X20 Y5 {0}5\nN3 G1 X-20\nN4 G3 X-20 Y-5 {0}5\nG0 Z5\nM30\n";

    // Half a turn whose start moves along its chord: its center moves by a hundredth. A radius of three decimals would leave it 0.09 mm
    // beside that.
    [Theory]
    [InlineData("fanuc", "R")]
    [InlineData("linuxcnc", "R")]
    [InlineData("siemens-840d", "CR=")]
    public void Half_a_turn_beside_a_moved_end_follows_everywhere(string dialect, string radius)
    {
        var path = Read(Slot.Replace("{0}", radius, StringComparison.Ordinal), dialect);
        var (rewrite, proof) = Proved(path, DisplacementWish.EndsBy(path, Bench.Blocks(path, "N1"), new(0, 0.02, 0)).Result!);
        var (was, now) = (Bench.MotionOf(path, "N2"), Bench.MotionOf(NcInterpreter.Run(rewrite.Program, path), "N2"));
        var moved = Furthest(was, now);
        Assert.InRange(moved, 0.02 - 1e-9, 0.02 + Rounding);
        Assert.Equal(moved, proof.Neighbors.Single(n => n.Block == "N2").DisplacementMm, 1e-6);
        Assert.False(now.Has(MotionFlags.ByRadius));
    }

    // The same arc with the radius that goes best with three decimals, 0.09 mm beside its place in the middle.
    [Fact]
    public void The_proof_finds_an_arc_that_bulges_between_its_ends()
    {
        var path = Bench.Read(Slot.Replace("{0}", "R", StringComparison.Ordinal));
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, "N1"), new(0, 0.02, 0)).Result!;
        var bad = NcProgram.FromText(Bench.Text(path.Program).Replace("N1 G1 X20", "N1 G1 X20 Y-4.98", StringComparison.Ordinal)
            .Replace("X20 Y5 R5", "X20 Y5 R-4.991", StringComparison.Ordinal));
        var proof = Prover.Check(path, bad, wish, Increment);
        Assert.False(proof.Holds);
        Assert.InRange(proof.MaxDeviationFromWantedMm, 0.08, 0.1);
        Assert.InRange(proof.Neighbors.Single(n => n.Block == "N2").DisplacementMm, 0.08, 0.1);
    }

    // Nearly a full circle, of which one end moves away from the center: between its ends it would move by five times as much.
    [Fact]
    public void An_arc_that_would_move_more_between_its_ends_is_refused()
    {
        const string Text = "G90 G17\nG0 X20. Y0.\nN1 G1 X10. Y0. F100\nN2 G3 X9.8480 Y-1.7370 I-10. J0.\nN3 G1 X20. Y-3.52\nG0 Z5.\n";
        var refusal = Bench.RefusedBy(Text, new(0.05, 0, 0), "N1");
        Assert.Equal((NcRefusalCodes.ElementFlips, 4), (refusal.Code, refusal.Place.Line));
        Assert.Contains("between its ends", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("fanuc", "G17", false)]
    [InlineData("fanuc", "G18", true)]
    [InlineData("linuxcnc", "G19", false)]
    [InlineData("linuxcnc", "G17", true)]
    [InlineData("siemens-840d", "G17", false)]
    [InlineData("siemens-840d", "G18", true)]
    public void No_arc_moves_anywhere_by_more_than_was_asked(string dialect, string plane, bool incremental)
    {
        var (displaced, refused) = (0, 0);
        for (var seed = 1; seed <= 80; seed++)
        {
            var random = new RandomContour(seed);
            var sweep = seed % 4 == 0 ? random.Uniform(170, 195) : random.Uniform(10, 350);
            var text = Arc(random, sweep, plane, incremental, dialect == "siemens-840d" ? "CR=" : "R");
            var path = Read(text, dialect);
            var by = Math.Round(random.Uniform(0.01, 0.1), 3);
            var along = Vector2.FromDirection(Angle.FromRadians(random.Uniform(-Math.PI, Math.PI))) * by;
            var named = Bench.Blocks(path, (seed % 5) switch { 0 => "N1", 1 => "N2", 2 => "N3", 3 => "N1..N2", _ => "N2..N3" });
            var wish = seed % 2 == 0
                ? DisplacementWish.EndsBy(path, named, Lifted(plane, along))
                : DisplacementWish.Normal(path, named, random.Uniform(0, 1) < 0.5 ? by : -by);
            var rewrite = Rewriter.Apply(path, Bench.Usable(wish));
            if (!rewrite.IsUsable)
            {
                Assert.True(
                    seed % 2 == 1 || sweep > 230 || rewrite.Refusal.Code is NcRefusalCodes.ArcForm, $"{seed}: {rewrite.Refusal}\n{text}");
                refused++;
                continue;
            }

            var proof = Prover.Check(path, rewrite.Result.Program, wish.Result!, rewrite.Result.LeastIncrementMm);
            Assert.True(proof.Holds, $"{seed}, {sweep}: {string.Join('\n', proof.Failures)}\n{text}\n{Bench.Text(rewrite.Result.Program)}");
            displaced++;
            var (was, now) = (Bench.MotionOf(path, "N2"), Bench.MotionOf(NcInterpreter.Run(rewrite.Result.Program, path), "N2"));
            var ends = Math.Max(was.PlaneStart.DistanceTo(now.PlaneStart), was.PlaneEnd.DistanceTo(now.PlaneEnd));
            var moved = Furthest(was, now);
            Assert.True(
                moved <= Math.Max(by, ends) + Rounding,
                string.Create(CultureInfo.InvariantCulture, $"{seed}, {sweep}: {moved} of {by}\n{text}"));
            if (proof.Neighbors.SingleOrDefault(n => n.Block == "N2") is { } neighbor)
            {
                Assert.Equal(moved, neighbor.DisplacementMm, 1e-5);
            }
        }

        Assert.True(displaced > 50, $"{refused} of 80 were refused");
    }

    // A line that meets an arc at a corner, the arc, and a line behind it. The arc's words are on the grid, so its radius is one of three
    // decimals.
    private static string Arc(RandomContour random, double sweep, string plane, bool incremental, string radius)
    {
        var (x, y, z) = plane switch { "G18" => ('Z', 'X', 'Y'), "G19" => ('Y', 'Z', 'X'), _ => ('X', 'Y', 'Z') };
        var r = Math.Round(random.Uniform(3, 30), 3);
        var turn = random.Uniform(0, 2 * Math.PI);
        var left = random.Uniform(0, 1) < 0.5 ? 1 : -1;
        Point2 At(double angle, double length) => new(
            Math.Round(length * Math.Cos(turn + (left * angle)), 3), Math.Round(length * Math.Sin(turn + (left * angle)), 3));
        var radians = sweep * Math.PI / 180;
        Point2[] places = [At(-0.3, r + 8), At(0, r), At(radians, r), At(radians + 0.3, r + 8)];
        var text = string.Create(
            CultureInfo.InvariantCulture,
            $"G90 {plane}\nG0 {x}{places[0].X:0.000} {y}{places[0].Y:0.000} {z}5.\nG1 {z}-1. F100\n{(incremental ? "G91\n" : "")}");
        for (var i = 1; i < places.Length; i++)
        {
            var to = incremental ? places[i] - places[i - 1] : places[i] - Point2.Origin;
            var move = i == 2 ? left > 0 ? "G3" : "G2" : "G1";
            var word = i == 2 ? string.Create(CultureInfo.InvariantCulture, $" {radius}{(sweep > 180 ? -r : r):0.000}") : "";
            text += string.Create(CultureInfo.InvariantCulture, $"N{i} {move} {x}{to.X:0.000} {y}{to.Y:0.000}{word}\n");
        }

        return text + $"G90 G0 {z}5.\nM30\n";
    }

    private static Vector3 Lifted(string plane, Vector2 by) => plane switch
    {
        "G18" => new(by.Y, 0, by.X),
        "G19" => new(0, by.X, by.Y),
        _ => new(by.X, by.Y, 0),
    };

    private static NcPath Read(string text, string dialect) =>
        NcDialects.Named(dialect) is var named ? NcInterpreter.Run(NcProgram.FromText(text, named.Syntax), named) : null!;

    private static (Rewrite Rewrite, NcProof Proof) Proved(NcPath path, DisplacementWish wish)
    {
        var rewrite = Bench.Rewritten(path, wish);
        return (rewrite, Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm));
    }

    // How far an end went, or a place of the new arc is beside the old circle.
    private static double Furthest(in NcMotion was, in NcMotion now)
    {
        var furthest = Math.Max(was.PlaneStart.DistanceTo(now.PlaneStart), was.PlaneEnd.DistanceTo(now.PlaneEnd));
        if (!was.IsArc)
        {
            return furthest;
        }

        var (radius, own) = (was.PlaneStart.DistanceTo(was.Center), now.PlaneStart.DistanceTo(now.Center));
        var from = Math.Atan2(now.PlaneStart.Y - now.Center.Y, now.PlaneStart.X - now.Center.X);
        var sweep = Math.Atan2(now.PlaneEnd.Y - now.Center.Y, now.PlaneEnd.X - now.Center.X) - from;
        sweep += now.Kind == MotionKind.ArcCounterClockwise ? (sweep <= 0 ? 2 * Math.PI : 0) : (sweep >= 0 ? -2 * Math.PI : 0);
        for (var i = 0; i <= 1000; i++)
        {
            var angle = from + (sweep * i / 1000);
            var (x, y) = (now.Center.X + (own * Math.Cos(angle)) - was.Center.X, now.Center.Y + (own * Math.Sin(angle)) - was.Center.Y);
            furthest = Math.Max(furthest, Math.Abs(Math.Sqrt((x * x) + (y * y)) - radius));
        }

        return furthest;
    }
}
