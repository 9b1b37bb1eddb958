using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

public class MotionComparisonTests
{
    private const string Program = "N10 G0 X0 Y0 Z5\nN20 G1 X10 F100\nN30 G2 X20 Y10 I0 J10\nN40 G1 Y20\n";

    [Fact]
    public void A_program_does_not_differ_from_itself() => Assert.Empty(Compare(Program, Program));

    [Fact]
    public void Another_spelling_is_no_difference() =>
        Assert.Empty(Compare(Program, Program.Replace("X10 F100", "X+10.000 F100.", StringComparison.Ordinal)));

    [Fact]
    public void Programs_of_one_length_are_aligned_by_order()
    {
        var differences = Compare(Program, "N10 G0 X0 Y0 Z5\nN20 G1 X10.02 Y-0.5 F100\nN30 G2 X20 Y10 I0 J10\nN40 G1 Y20 F90\n");
        Assert.Equal(
            [(MotionChange.Moved, 1, 1), (MotionChange.Moved, 2, 2), (MotionChange.Feed, 3, 3)],
            differences.Select(d => (d.Change, d.Before, d.After)));
        Assert.Equal(0.02, differences[0].Displacement.X, 1e-12);
        Assert.Equal(-0.5, differences[0].Displacement.Y, 1e-12);

        // The arc ends where it did, but its center words count from the moved start.
        Assert.Equal(Vector3.Zero, differences[1].Displacement);
        Assert.Equal(-0.5, differences[1].CenterDisplacement.Y, 1e-12);
    }

    [Fact]
    public void Another_kind_of_motion_replaces_the_first() =>
        Assert.Equal(
            [MotionChange.Replaced], Compare(Program, Program.Replace("G1 Y20", "G0 Y20", StringComparison.Ordinal)).Select(d => d.Change));

    [Fact]
    public void An_inserted_motion_leaves_the_others_aligned()
    {
        Assert.Equal(
            [(MotionChange.Inserted, -1, 2)],
            Compare(
                Program,
                Program.Replace("N30", "X10 Y0.001\nY0\nN30", StringComparison.Ordinal).Replace("Y0\nN30", "N30", StringComparison.Ordinal)
            .Replace("I0 J10", "I0 J9.999", StringComparison.Ordinal)).Select(d => (d.Change, d.Before, d.After)));
        Assert.Equal(
            [(MotionChange.Removed, 3, -1)],
            Compare(Program, Program.Replace("N40 G1 Y20\n", "", StringComparison.Ordinal)).Select(d => (d.Change, d.Before, d.After)));
    }

    [Fact]
    public void Moved_motions_are_found_again_by_their_block_numbers()
    {
        var differences = Compare(Program, "N10 G0 X0 Y0 Z5\nN20 G1 X10 Y1 F100\nG1 X11 Y1\nN30 G2 X20 Y12 I0 J10\nN40 G1 Y20\n");
        Assert.Equal(
            [(MotionChange.Moved, 1, 1), (MotionChange.Inserted, -1, 2), (MotionChange.Moved, 2, 3)],
            differences.Select(d => (d.Change, d.Before, d.After)));
    }

    [Fact]
    public void A_common_subsequence_is_as_long_as_the_table_of_all_prefixes_says() => Prop.ForAll<int[], int[]>((a, b) =>
    {
        // Few different items, so that most repeat.
        int[] first = [.. a.Select(i => i & 3)], second = [.. b.Select(i => i & 3)];
        var pairs = CommonSubsequence.Of(first, second);
        Assert.All(pairs, p => Assert.Equal(first[p.First], second[p.Second]));
        Assert.All(pairs.Zip(pairs.Skip(1)), p => Assert.True(p.First.First < p.Second.First && p.First.Second < p.Second.Second));
        var table = new int[first.Length + 1, second.Length + 1];
        for (var i = 1; i <= first.Length; i++)
        {
            for (var j = 1; j <= second.Length; j++)
            {
                table[i, j] = first[i - 1] == second[j - 1] ? table[i - 1, j - 1] + 1 : Math.Max(table[i - 1, j], table[i, j - 1]);
            }
        }

        Assert.Equal(table[first.Length, second.Length], pairs.Count);
    }).QuickCheckThrowOnFailure();

    [Theory]
    [InlineData("T1", "T2", MotionChange.Tool)]
    [InlineData("M6", "", MotionChange.Tool)]
    [InlineData("S1000", "S1001", MotionChange.Spindle)]
    [InlineData("M3", "M4", MotionChange.Spindle)]
    [InlineData("M8", "M9", MotionChange.Words)]
    [InlineData("G54", "G55", MotionChange.Words)]
    [InlineData("G41 D1", "G41 D2", MotionChange.Words)]
    [InlineData("G4 X1.", "G4 X2.", MotionChange.Words)]
    [InlineData("G4 P1", "G4 P1\nM0", MotionChange.Words)]
    [InlineData("#1=5", "#1=6", MotionChange.Words)]
    public void Words_that_move_nothing_are_compared(string was, string now, MotionChange change)
    {
        const string text = "G54 G90\nT1\nM6\nS1000 M3\nG0 X0 Y0 Z5\nM8\n#1=5\nG4 X1.\nG4 P1\nG41 D1 G1 X5 F100\nX10\n";
        var difference = Assert.Single(Compare(text, Replaced(text, was + "\n", now + "\n", was)));
        Assert.Equal(change, difference.Change);
        Assert.Equal(Vector3.Zero, difference.Displacement);
        Assert.NotEqual(difference.Functions!.Before, difference.Functions.After);

        static string Replaced(string text, string was, string now, string word) =>
            text.Contains(was, StringComparison.Ordinal)
                ? text.Replace(was, now, StringComparison.Ordinal)
                : text.Replace(word, now.TrimEnd(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("N20 G1 X10 F100", "N20 G01 X10. F100.0")]
    [InlineData("N20 G1 X10 F100", "N25 (finish) G1 F100 X10")]
    [InlineData("N20 G1 X10 F100", "N20 G91 G1 X10 F100 G90")]
    [InlineData("N20 G1 X10 F100", "n20g1x10f100")]
    [InlineData("N20 G1 X10 F100", "N20 F100\n\nG1 X10")]
    public void Renumbered_and_reformatted_blocks_do_the_same(string was, string now)
    {
        // With G91 for one block, G90 must stand before the next motion.
        var text = Program.Replace(was, now.Replace(" G90", "", StringComparison.Ordinal), StringComparison.Ordinal);
        text = now.Contains("G91", StringComparison.Ordinal) ? text.Replace("N30 G2", "N30 G90 G2", StringComparison.Ordinal) : text;
        var comparison = MotionComparison.Of(Run("G90\n" + Program), Run("G90\n" + text));
        Assert.True(comparison.IsSame, string.Join(';', comparison.Differences));
        Assert.Equal(4, comparison.Identical);
    }

    [Fact]
    public void Motions_without_numbers_are_aligned_by_place_though_one_went_and_one_came()
    {
        var before = string.Concat(Enumerable.Range(0, 200).Select(i => $"G1 X{i * 2} Y{i % 7}\n"));
        var lines = before.Split('\n').ToList();
        lines[50] = "G1 X100.01 Y1";
        lines.RemoveAt(150);
        lines.Insert(100, "G1 X199 Y3");
        Assert.Equal(
            [(MotionChange.Moved, 50, 50), (MotionChange.Inserted, -1, 100), (MotionChange.Removed, 150, -1)],
            Compare(before, string.Join('\n', lines)).Select(d => (d.Change, d.Before, d.After)));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(70)]
    public void A_wholly_displaced_program_with_one_motion_more_is_moved_and_not_replaced(int at)
    {
        var lines = Enumerable.Range(0, 100).Select(i => $"G1 X{i * 2} Y{i % 7}").ToList();
        var moved = Enumerable.Range(0, 100).Select(i => $"G1 X{i * 2}.05 Y{i % 7}.02").ToList();
        moved.Insert(at, FormattableString.Invariant($"G1 X{(at * 2) - 1} Y30"));
        var differences = Compare(string.Join('\n', lines), string.Join('\n', moved));
        Assert.Equal([at], differences.Where(d => d.Change == MotionChange.Inserted).Select(d => d.After));
        Assert.Equal(
            100,
            differences.Count(
                d => d.Change == MotionChange.Moved
                    && Math.Abs(d.Displacement.X - 0.05) < 1e-9
                    && Math.Abs(d.Displacement.Y - 0.02) < 1e-9));
    }

    [Fact]
    public void What_differs_behind_the_last_motion_is_said()
    {
        var comparison = MotionComparison.Of(Run(Program + "M5\nM30\n"), Run(Program + "M30\n"));
        Assert.Empty(comparison.Differences);
        Assert.False(comparison.IsSame);
        Assert.Equal(["M5", "M30"], comparison.AtEnd!.Before);
        Assert.Equal(["M30"], comparison.AtEnd.After);
    }

    [Fact]
    public void As_many_motions_are_the_same_there_and_back_and_as_many_are_left_as_pairs() => Prop.ForAll<int[], int[]>((a, b) =>
    {
        var (first, second) = (Lines(a), Lines(b));
        Assert.Equal(MotionComparison.Of(Run(first), Run(second)).Identical, MotionComparison.Of(Run(second), Run(first)).Identical);
        var there = Compare(first, second);
        Assert.Equal(a.Length - there.Count(d => d.Before >= 0), b.Length - there.Count(d => d.After >= 0));

        static string Lines(int[] items) => string.Concat(items.Select(i => $"G1 X{i & 7} Y0\n")) + "\n";
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void A_hundred_thousand_blocks_with_few_or_all_different_are_compared_to_the_last()
    {
        var before = string.Concat(Enumerable.Range(0, 100_000).Select(i => $"G1 X{i % 100} Y{i % 77} Z-{i / 1000}\n"));
        var few = before.Replace("G1 X0 Y11 Z-7\n", "", StringComparison.Ordinal);
        var all = before.Replace("\n", ".001\n", StringComparison.Ordinal);
        var missing = (before.Length - few.Length) / "G1 X0 Y11 Z-7\n".Length;
        Assert.Equal(missing, Compare(before, few).Count(d => d.Change == MotionChange.Removed));
        Assert.Equal(100_000, Compare(before, all).Count(d => d.Change == MotionChange.Moved));
    }

    [Fact]
    public void Side_by_side_every_block_stands_once_and_changed_words_are_marked()
    {
        var comparison = MotionComparison.Of(
            Run("(A)\nN10 G1 X1 Y1\nM8\nN20 X2\nN30 X3\n"), Run("(A)\nN10 G1 X1.0 Y2\nN15 M9\nX2\nX2.5\nN40 X3\n"));
        var rows = SideBySide.Of(comparison);
        Assert.Equal(
            [(0, 0, true), (1, 1, false), (2, 2, false), (3, 3, true), (-1, 4, false), (4, 5, true)],
            rows.Select(r => (r.Before, r.After, r.IsSame)));
        var (before, after) = (comparison.Before.Program, comparison.After.Program);
        var words = SideBySide.Words(before, before[1], after, after[1]);
        Assert.Equal(["Y1"], words.Before.Select(r => "N10 G1 X1 Y1"[r]));
        Assert.Equal(["Y2"], words.After.Select(r => "N10 G1 X1.0 Y2"[r]));
    }

    [Theory]
    [InlineData("N10 G1 X1. Y-2 (note) F100\r\n%\n", 2, 5)]
    [InlineData("", 0, 0)]
    [InlineData("\n\r\n#1=2\nX#1 Y[1+2] ,R5. GOTO 5 ?\u00e9\rG1", 5, 5)]
    public void A_census_counts_words_and_copies_every_byte(string text, int blocks, int words) =>
        Assert.Equal(new NcCensus(blocks, words, true), NcCensus.Of(NcProgram.FromText(text)));

    private static IReadOnlyList<MotionDifference> Compare(string before, string after) =>
        MotionComparison.Of(Run(before), Run(after)).Differences;

    private static NcPath Run(string text) => NcInterpreter.Run(NcProgram.FromText(text), NcDialects.Generic);
}
