using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>Every plausible run of blocks of a program can be displaced, with a proof, or is refused with a reason; the proof never finds
/// what the rewriter should have refused. <c>tests/corpora --displace</c> does the same with the programs of a folder.</summary>
public sealed class EveryRunTests
{
    private const string Passes =
        "G21 G90 G17\nG0 X0 Y0 Z0\nN1 G1 X100 F500\nN2 Y100\nN3 X0\nN4 Y0\nG1 Z-10\nN5 X100\nN6 Y100\nN7 X0\nN8 Y0\nG0 Z50.\nM30\n";

    // Passes in depth without a retract, one below the other: each closes where the tool then goes straight down.
    [Fact]
    public void Passes_in_depth_close_and_are_alike()
    {
        var now = NcInterpreter.Run(NcProgram.FromText(Bench.Normal(Passes, 0.02, "N1..N8")), NcDialects.Generic);
        Assert.Equal(
            [new(0.02, 0.02), new(99.98, 0.02), new(99.98, 99.98), new(0.02, 99.98), new(0.02, 0.02), new(0.02, 0.02), new(99.98, 0.02),
                new(99.98, 99.98), new(0.02, 99.98), new(0.02, 0.02), new Point2(0.02, 0.02)],
            now.Motions.Select(m => new Point2(Math.Round(m.End.X, 6), Math.Round(m.End.Y, 6))));
    }

    // The last cut of one pass and the first of the next: both passes would no longer close.
    [Theory]
    [InlineData("N4..N5", "N1")]
    [InlineData("N3..N5", "N1")]
    [InlineData("N2..N6", "N1")]
    [InlineData("N1..N6", "N8")]
    public void Half_of_two_passes_is_refused_with_what_to_name(string named, string missing)
    {
        var refusal = Bench.RefusedNormal(Passes, 0.02, named);
        Assert.Equal(NcRefusalCodes.NoIntersection, refusal.Code);
        Assert.Contains($" {missing}, ", refusal.Message, StringComparison.Ordinal);
    }

    // A way in that is named too must lead to where the passes below it close.
    [Fact]
    public void A_named_way_in_to_passes_is_refused() => Assert.Contains(
        "leads in to the closed contour",
        Bench.RefusedNormal(
            "G90 G17\nG0 X-5. Y-4. Z2.\nG1 Z-1. F100\nN1 X0. Y0.\nN2 X30.\nN3 Y20.\nN4 X0. Y0.\n"
                + "G1 Z-2.\nN5 X30.\nN6 Y20.\nN7 X0. Y0.\nG0 Z5.\n",
            0.02, "N1..N7").Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData("", 0.02)]
    [InlineData("", -0.02)]
    [InlineData("G41 D1 ", 0.02)]
    [InlineData("G42 D1 ", 0.02)]
    public void A_full_circle_keeps_its_center_in_each_pass(string compensation, double left)
    {
        var text = $"G90 G17\nG0 X-6. Y-7. Z2.\nG1 Z-1. F100\nN1 {compensation}X0. Y0.\nN2 G3 I10. J3.\nG1 Z-2.\nN3 G3 I10. J3.\n"
            + $"N4 {(compensation == "" ? "" : "G40 ")}G1 X-6. Y-7.\nG0 Z5.\n";
        var path = Bench.Read(text);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N2..N3"), left).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path);
        foreach (var name in new[] { "N2", "N3" })
        {
            var arc = Bench.MotionOf(now, name);
            Assert.Equal(arc.PlaneStart, arc.PlaneEnd);
            Assert.Equal(0, arc.Center.DistanceTo(new(10, 3)), 0.001);
            Assert.Equal(Math.Sqrt(109) - left, arc.Arc.Radius, 0.0016);
        }
    }

    [Fact]
    public void A_full_circle_below_or_above_must_be_named_too() => Assert.Contains(
        "Name it as well",
        Bench.RefusedNormal("G90 G17\nG0 X0. Y0. Z2.\nG1 Z-1. F100\nN1 G3 I10.\nG1 Z-2.\nN2 G3 I10.\nG0 Z5.\n", 0.02, "N1").Message,
        StringComparison.Ordinal);

    // The retract goes up where the arc now ends, so the rapid to its old end moves in the plane, and G40 takes effect with it.
    [Fact]
    public void A_block_that_begins_to_move_behind_a_switch_is_refused() => Assert.Equal(
        NcRefusalCodes.CompensationEntry,
        Bench.RefusedBy(
            "G90 G17\nG0 X0. Y0. Z0.\nG41 D1 G1 X10. F100\nN1 X20. Y10.\nG0 Z5.\nG40\nG0 X20. Y10.\nG1 X50.\nM30\n",
            new(0.01, 0.02, 0), "N1").Code);

    // What is left of the end of a polyline meets the way out at 5 degrees: the way out follows.
    [Fact]
    public void An_end_whose_last_pieces_vanish_does_not_slide_along_a_shallow_way_out()
    {
        const string Text =
            "G90 G17\nG0 X15.037 Y200.866 Z2.\nG1 Z-1. F20.\nN6 G1 X17.693 Y199.646\nN7 G3 X23.77 Y191.185 I7.269 J-1.192\n"
                + "N8 G1 X23.931 Y191.144\nN9 G1 X53.604 Y187.209\nG0 Z50.\nM30\n";
        Bench.Normal(Text, -0.02, "N7..N8");
    }

    [Fact]
    public void Every_run_of_the_corpus_is_proved_or_refused()
    {
        var (proved, failed) = (0, new List<string>());
        var folder = Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "Corpus");
        foreach (var file in Directory.GetFiles(folder, "*.*", SearchOption.AllDirectories))
        {
            var name = Path.GetFileName(Path.GetDirectoryName(file)) switch
            {
                "siemens" => "siemens-840d",
                "linuxcnc" => "linuxcnc",
                "okuma" => "okuma-osp",
                _ => "fanuc",
            };
            var dialect = NcDialects.Named(name);
            var path = NcInterpreter.Run(NcProgram.Read(File.ReadAllBytes(file), dialect.Syntax), dialect);
            Judge(Path.GetFileName(file), path, ref proved, failed);
        }

        Assert.Empty(failed);
        Assert.True(proved > 200, $"{proved} were proved");
    }

    [Fact]
    public void Every_run_of_random_passes_in_depth_is_proved_or_refused()
    {
        var (proved, failed) = (0, new List<string>());
        for (var seed = 1; seed <= 60; seed++)
        {
            var text = Depth(new(seed, anyCorner: true), seed);
            Judge($"{seed}\n{text}\n", Bench.Read(text), ref proved, failed);
        }

        Assert.Empty(failed);
        Assert.True(proved > 500, $"{proved} were proved");
    }

    // Displaces runs of the contours of a program: each whole, its first, its last, and without these; and two contours together.
    private static void Judge(string name, NcPath path, ref int proved, List<string> failed)
    {
        var (contours, first) = (new List<(int First, int Last)>(), -1);
        for (var i = 0; i <= path.Motions.Length; i++)
        {
            var isCut = i < path.Motions.Length && path.Motions[i] is { IsCut: true, MovesInPlane: true };
            (first, var ended) = isCut ? (first < 0 ? i : first, -1) : (-1, first);
            if (ended >= 0)
            {
                contours.Add((ended, i - 1));
            }
        }

        var runs = new HashSet<(int First, int Last)>();
        for (var k = 0; k < Math.Min(contours.Count, 6); k++)
        {
            var (from, to) = contours[k];
            runs.UnionWith([(from, to), (from, from), (to, to), (Math.Min(from + 1, to), to), (from, Math.Max(from, to - 1))]);
            runs.Add((from, contours[Math.Min(k + 1, contours.Count - 1)].Last));
        }

        foreach (var (from, to) in runs)
        {
            int[] blocks = [.. Enumerable.Range(from, to - from + 1).Select(i => path.Motions[i].Block).Distinct().Order()];
            foreach (var wish in (Outcome<DisplacementWish>[])[
                DisplacementWish.Normal(path, blocks, 0.02), DisplacementWish.Normal(path, blocks, -0.02),
                DisplacementWish.EndsBy(path, blocks, new(0.01, 0.02, 0))])
            {
                if (wish.IsUsable && Rewriter.Apply(path, wish.Result) is { IsUsable: true, Result: { } rewrite })
                {
                    var proof = Prover.Check(path, rewrite.Program, wish.Result, rewrite.LeastIncrementMm);
                    proved += proof.Holds ? 1 : 0;
                    failed.AddRange(proof.Failures.Select(f => string.Create(
                        CultureInfo.InvariantCulture, $"{name}, lines {blocks[0] + 1} to {blocks[^1] + 1}: {f}")));
                }
            }
        }
    }

    // A random contour, open or closed, two to four times without a retract: from its start again, or back and forth.
    private static string Depth(RandomContour contour, int seed)
    {
        var lines = contour.Spell(byRadius: seed % 3 == 0).Split('\n');
        var cuts = lines.Where(l => l.StartsWith('N')).ToList();
        var start = lines.First(l => l.StartsWith("G0 ", StringComparison.Ordinal));
        var close = $"G1 {start[3..start.IndexOf(" Z", StringComparison.Ordinal)]}";
        var text = $"G21 G40 G90 G17\n{start}\nG1 Z-1. F500.\n";
        for (var pass = 1; pass <= 2 + (seed % 3); pass++)
        {
            text += (pass == 1 ? "" : seed % 5 == 0 ? "" : $"G1 Z-{pass}.\n")
                + string.Concat(cuts.Select(c => c[(c.IndexOf(' ') + 1)..] + "\n"));
            text += seed % 5 == 0 ? $"{close} Z-{pass + 1}.\n" : $"{close}\n";
        }

        return text + "G0 Z5.\nM30\n";
    }
}
