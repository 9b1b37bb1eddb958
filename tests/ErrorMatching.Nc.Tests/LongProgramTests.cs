using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>What serves long programs gives what a plain walk gives.</summary>
public sealed class LongProgramTests
{
    private static readonly Gen<string> Paths = Gen.Elements(
        "G1 X{0}. Y{1}.",
        "G1 X{0}. Y{1}.",
        "G1 X{0}.0001 Y{1}.",
        "G1 X{0}.00005 Y{1}.",
        "G1 X{0}.0000496 Y{1}.",
        "G0 X{0}. Y{1}.",
        "G3 X{0}. Y{1}. R9.",
        "G1 Z{0}.",
        "G55",
        "G41 G1 X{0}. Y{1}.",
        "G40 G1 X{0}. Y{1}.")
        .Zip(Gen.Choose(0, 3).Two()).Select(
            p => p.Item1.Replace(
                "{0}",
                p.Item2.Item1.ToString(CultureInfo.InvariantCulture),
                StringComparison.Ordinal).Replace("{1}", p.Item2.Item2.ToString(CultureInfo.InvariantCulture), StringComparison.Ordinal))
        .ArrayOf().Select(l => "G90 G17 G21 G54\nG0 X0 Y0 Z0\n" + string.Join('\n', l));

    [Fact]
    public void Sorted_contours_close_where_a_walk_finds_that_they_do() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(500, 2000)).WithEndSize(60), Prop.ForAll(Paths.ToArbitrary(), text =>
        {
            var motions = Bench.Read(text).Motions;
            var (walking, sorted) = (new ContourSearch(motions, 1e-6, 1), new ContourSearch(motions, 1e-6, 1000));
            var same = true;
            for (var i = 0; i < motions.Length; i++)
            {
                var from = (i * 7) % motions.Length;
                same &= walking.FirstEndingAt(motions[i].Start, i + 1, i) == sorted.FirstEndingAt(motions[i].Start, i + 1, i);
                same &= walking.LastStartingAt(motions[i].End, i - 1, i) == sorted.LastStartingAt(motions[i].End, i - 1, i);
                same &= walking.FirstEndingAt(motions[i].Start + new Vector3(4e-7, 0, 0), from, i)
                    == sorted.FirstEndingAt(motions[i].Start + new Vector3(4e-7, 0, 0), from, i);
                same &= walking.LastStartingAt(motions[i].End + new Vector3(0, 5e-5, 0), from, i)
                    == sorted.LastStartingAt(motions[i].End + new Vector3(0, 5e-5, 0), from, i);
            }

            return same;
        }));

    [Theory]
    [InlineData("X5. Y0.50")]
    [InlineData("X5. Y0.12345")]
    [InlineData("X5. Y0.5 Z1.00")]
    public void A_block_that_is_spelled_otherwise_far_behind_counts_for_all(string odd)
    {
        // As many blocks as are read before they are edited, and so many that the first stand for all.
        string Displaced(int blocks)
        {
            var lines = Enumerable.Range(0, blocks).Select(
                i => i == 5000 ? "G1 " + odd : string.Create(CultureInfo.InvariantCulture, $"G1 X{i % 7}. Y0.{1 + (i % 2)}"));
            var path = Bench.Read("G90 G17 G21 G54\nG0 X0 Y0 Z0\n" + string.Join('\n', lines) + "\n");
            var wish = DisplacementWish.EndsBy(path, [.. Enumerable.Range(2, blocks)], new(0.1, 0.00012, 0));
            return Encoding.UTF8.GetString(Rewriter.Apply(path, wish.Result!).Result!.Program.Bytes.Span);
        }

        var (few, many) = (Displaced(9_000), Displaced(12_000));
        Assert.Equal(few.Split('\n')[..8_000], many.Split('\n')[..8_000]);
    }

    [Fact]
    public void Places_beyond_any_machine_are_searched_as_well()
    {
        var motions = Bench.Read("G90 G17 G21\nG0 X999999999999999 Y0 Z0\nG1 X0 F100\nG1 X999999999999999\n").Motions;
        Assert.Equal(2, new ContourSearch(motions, 1e-6, 1000).FirstEndingAt(motions[1].Start, 1, 1));
    }

    [Fact]
    public void Runs_of_motions_answer_as_a_list_of_them_does() =>
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(500, 2000)),
            Prop.ForAll(Gen.Choose(0, 60).ListOf().Zip(Gen.Choose(-2, 62).ListOf()).ToArbitrary(), p =>
        {
            List<int> named = [.. p.Item1.Distinct().Order()];
            var runs = new MotionRuns();
            named.ForEach(runs.Add);
            return p.Item2.All(m => runs.IndexOf(m) == Math.Max(-1, named.IndexOf(m)))
                && Enumerable.Range(0, runs.Count)
                    .SelectMany(r => Enumerable.Range(runs[r].First, runs[r].Last - runs[r].First + 1))
                    .SequenceEqual(named);
        }));

    [Fact]
    public void The_tree_of_boxes_finds_the_feet_that_looking_at_all_motions_finds() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(500), Prop.ForAll(Gen.Choose(1, 100_000).ToArbitrary(), seed =>
        {
            var contour = new RandomContour(seed);
            var path = Bench.Read(contour.Spell());
            int[] motions = [
                .. Enumerable.Range(0, path.Motions.Length).Where(i => path.Motions[i] is { IsCut: true, MovesInPlane: true })];
            var tree = new PathTree(path, motions);
            var place = new Point2(contour.Uniform(-60, 60), contour.Uniform(-60, 60));
            var all = motions.Select(m => new PathFoot(0, m, 0) with { DistanceMm = Distance(path.Motions[m], place) }).ToArray();
            var feet = new List<PathFoot>();
            tree.Collect(place, 20, feet);
            return tree.NearestTo(place).Motion == all.MinBy(f => f.DistanceMm).Motion
                && feet.Select(f => f.Motion).SequenceEqual(all.Where(f => f.DistanceMm <= 20).Select(f => f.Motion));
        }));

    [Fact]
    public void As_many_blocks_as_take_a_second_core_change_as_few_do()
    {
        // 12,000 blocks in one run, and the same in four: the parts meet in joints that the whole has inside.
        var text = new StringBuilder("G90 G17 G21\nG0 X0. Y0. Z5.\nG1 Z-1. F500.\n");
        for (var i = 1; i <= 12_000; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"N{i} X{0.2 * i:0.###} Y{5 * Math.Sin(0.01 * i):0.###}\n");
        }

        var path = Bench.Read(text.ToString());
        var rewrite = Bench.Rewritten(path, Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N1..N12000"), 0.05)));
        // The rapid to their start goes along.
        Assert.Equal(12_001, rewrite.ChangedBlocks.Count);
        Assert.Equal(rewrite.ChangedBlocks.Order(), rewrite.ChangedBlocks);
        Assert.Equal(rewrite.Patches.OrderBy(p => p.Start), rewrite.Patches);
        for (var first = 1; first < 12_000; first += 3000)
        {
            var part = Bench.Rewritten(
                path, Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, $"N{first}..N{first + 2999}"), 0.05)));
            for (var block = first + 10; block < first + 2980; block++)
            {
                Assert.Equal(part.Program.TextOf(part.Program[block]), rewrite.Program.TextOf(rewrite.Program[block]));
            }
        }
    }

    [Fact]
    public void A_change_far_from_all_named_blocks_is_found_in_a_long_program()
    {
        var text = new StringBuilder("G90 G17 G21\nG0 X0. Y0. Z5.\nG1 Z-1. F500.\n");
        for (var i = 1; i <= 20_000; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"N{i} X{0.2 * i:0.000} Y{5 * Math.Sin(0.01 * i):0.000}\n");
        }

        var path = Bench.Read(text.ToString());
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N100..N110"), 0.05));
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        foreach (var (was, now) in new[]
        {
            ("N1 X", "N1  X"),
            ("N15000 X", "N15001 X"),
            ("N19999 X3999.800", "N19999 X3999.801"),
            ("N19999 X3999.800", "N19999 X3999.80"),
            ("N8000 X1600.000", "N8000 X1600.000 M8")
        })
        {
            Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal)), wish, 0.001).Holds, now);
        }
    }

    [Fact]
    public void A_hundred_thousand_words_before_an_operand_are_one_operand()
    {
        var program = NcProgram.FromText("X=" + string.Concat(Enumerable.Repeat("NOT ", 100_000)) + "1", NcSyntax.Siemens);
        var tokens = 0;
        foreach (var token in program.Tokens(program[0]))
        {
            Assert.Equal(program.Bytes.Length, token.Length);
            tokens++;
        }

        Assert.Equal(1, tokens);
    }

    private static double Distance(in NcMotion motion, Point2 place) =>
        motion.PlaneAt(motion.IsArc ? motion.Arc.NearestFraction(place) : motion.Segment.NearestFraction(place)).DistanceTo(place);
}
