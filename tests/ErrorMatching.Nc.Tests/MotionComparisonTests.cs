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
    public void Another_spelling_is_no_difference() => Assert.Empty(Compare(Program, Program.Replace("X10 F100", "X+10.000 F100.", StringComparison.Ordinal)));

    [Fact]
    public void Programs_of_one_length_are_aligned_by_order()
    {
        var differences = Compare(Program, "N10 G0 X0 Y0 Z5\nN20 G1 X10.02 Y-0.5 F100\nN30 G2 X20 Y10 I0 J10\nN40 G1 Y20 F90\n");
        Assert.Equal([(MotionChange.Moved, 1, 1), (MotionChange.Moved, 2, 2), (MotionChange.Feed, 3, 3)], differences.Select(d => (d.Change, d.Before, d.After)));
        Assert.Equal(0.02, differences[0].Displacement.X, 1e-12);
        Assert.Equal(-0.5, differences[0].Displacement.Y, 1e-12);

        // The arc ends where it did, but its center words count from the moved start.
        Assert.Equal(Vector3.Zero, differences[1].Displacement);
        Assert.Equal(-0.5, differences[1].CenterDisplacement.Y, 1e-12);
    }

    [Fact]
    public void Another_kind_of_motion_replaces_the_first() =>
        Assert.Equal([MotionChange.Replaced], Compare(Program, Program.Replace("G1 Y20", "G0 Y20", StringComparison.Ordinal)).Select(d => d.Change));

    [Fact]
    public void An_inserted_motion_leaves_the_others_aligned()
    {
        Assert.Equal([(MotionChange.Inserted, -1, 2)], Compare(Program, Program.Replace("N30", "X10 Y0.001\nY0\nN30", StringComparison.Ordinal).Replace("Y0\nN30", "N30", StringComparison.Ordinal)
            .Replace("I0 J10", "I0 J9.999", StringComparison.Ordinal)).Select(d => (d.Change, d.Before, d.After)));
        Assert.Equal([(MotionChange.Removed, 3, -1)], Compare(Program, Program.Replace("N40 G1 Y20\n", "", StringComparison.Ordinal)).Select(d => (d.Change, d.Before, d.After)));
    }

    [Fact]
    public void Moved_motions_are_found_again_by_their_block_numbers()
    {
        var differences = Compare(Program, "N10 G0 X0 Y0 Z5\nN20 G1 X10 Y1 F100\nG1 X11 Y1\nN30 G2 X20 Y12 I0 J10\nN40 G1 Y20\n");
        Assert.Equal([(MotionChange.Moved, 1, 1), (MotionChange.Inserted, -1, 2), (MotionChange.Moved, 2, 3)], differences.Select(d => (d.Change, d.Before, d.After)));
    }

    [Fact]
    public void A_common_subsequence_is_as_long_as_the_table_of_all_prefixes_says() => Prop.ForAll<int[], int[]>((a, b) =>
    {
        // Few different items, so that most repeat.
        object[] first = [.. a.Select(i => (object)(i & 3))], second = [.. b.Select(i => (object)(i & 3))];
        var pairs = CommonSubsequence.Of(first, second);
        Assert.All(pairs, p => Assert.Equal(first[p.First], second[p.Second]));
        Assert.All(pairs.Zip(pairs.Skip(1)), p => Assert.True(p.First.First < p.Second.First && p.First.Second < p.Second.Second));
        var table = new int[first.Length + 1, second.Length + 1];
        for (var i = 1; i <= first.Length; i++)
        {
            for (var j = 1; j <= second.Length; j++)
            {
                table[i, j] = first[i - 1].Equals(second[j - 1]) ? table[i - 1, j - 1] + 1 : Math.Max(table[i - 1, j], table[i, j - 1]);
            }
        }

        Assert.Equal(table[first.Length, second.Length], pairs.Count);
    }).QuickCheckThrowOnFailure();

    [Theory]
    [InlineData("N10 G1 X1. Y-2 (note) F100\r\n%\n", 2, 5)]
    [InlineData("", 0, 0)]
    [InlineData("\n\r\n#1=2\nX#1 Y[1+2] ,R5. GOTO 5 ?\u00e9\rG1", 5, 5)]
    public void A_census_counts_words_and_copies_every_byte(string text, int blocks, int words) =>
        Assert.Equal(new NcCensus(blocks, words, true), NcCensus.Of(NcProgram.FromText(text)));

    private static IReadOnlyList<MotionDifference> Compare(string before, string after) => MotionComparison.Of(Run(before), Run(after)).Differences;

    private static NcPath Run(string text) => NcInterpreter.Run(NcProgram.FromText(text), NcDialects.Generic);
}
