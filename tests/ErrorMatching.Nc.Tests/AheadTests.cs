using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// A program of 100,000 blocks and more is begun in its middle as well.
/// A program that is a little shorter is not, so that the two must agree in all blocks that they share.
/// </summary>
public class AheadTests
{
    private const int Long = 100_352;
    private const int Short = 99_900;
    private const int Middle = Long / 2;

    [Fact]
    public void Lines_and_arcs_are_the_same_wherever_they_were_begun() => AssertSame(i => i % 7 == 3
        ? Text($"N{i} G{2 + (i % 2)} X{i + 1} Y{i % 5} R9.5")
        : i % 11 == 0
            ? Text($"G0 X{i} Y{i % 3}. Z{i % 4}.5")
            : Text($"N{i} G1 X{i}.25 Y{i % 13}.125 Z-{i % 4}.5{(i % 50 == 0 ? " F" + (i % 900) : "")}"));

    [Theory]
    [InlineData("G91")]
    [InlineData("Z-7.5")]
    [InlineData("G18")]
    [InlineData("G41")]
    [InlineData("G20")]
    [InlineData("G68 X0 Y0 R30")]
    [InlineData("G52 X3")]
    [InlineData("M98 P2000 (UNKNOWN)")]
    [InlineData("F123")]
    public void What_was_set_between_the_beginning_and_the_middle_counts_in_the_second_half(string set)
    {
        AssertSame(i => i == 20_000 ? set : Text($"G1 X{i % 17}.5 Y{i % 29}"));
    }

    [Theory]
    [InlineData(Middle - 1)]
    [InlineData(Middle)]
    [InlineData(Middle + 1)]
    [InlineData(Middle - 4_000)]
    [InlineData(Middle + 30_000)]
    public void What_is_more_than_a_motion_stands_where_it_stands(int place)
    {
        foreach (var text in new[]
        {
            "(A COMMENT)",
            "G4 P1",
            "M8",
            "G92 X0 Y0",
            "G81 X1 Y1 Z-1 R1",
            "G2 X50 Y50 I1 J0",
            "G1 X5 Q8",
            "G54",
            "#1=2"
        })
        {
            AssertSame(i => i == place ? text : Text($"G1 X{i % 17}.5 Y{i % 29} Z1"));
        }
    }

    [Fact]
    public void A_loop_around_the_middle_runs_as_often_as_it_says()
    {
        const int Loop = 1_000;
        var text = Program(
            i => i == Middle - Loop ? "#1=0\nWHILE [#1 LT 3] DO1" : i == Middle + Loop ? "#1=#1+1\nEND1" : Text($"G1 X{i} Y{i % 29}"),
            Long);
        var path = Bench.Read(text, NcDialects.FanucMill);
        Assert.Null(path.Refusal);
        Assert.Equal(Long - 2 + (2 * ((2 * Loop) - 1)), path.Motions.Length);
        for (var i = 1; i < path.Motions.Length; i++)
        {
            var (a, b) = (path.Motions[i - 1].End.X, path.Motions[i].End.X);
            Assert.True(b == a + 1 || b == a + 2 || (a == Middle + Loop - 1 && b == Middle - Loop + 1), Text($"from {a} to {b}"));
        }
    }

    [Fact]
    public void A_program_that_ends_before_its_middle_has_no_more_motions()
    {
        var path = Bench.Read(Program(i => i == 30_000 ? "M30" : Text($"G1 X{i}"), Long), NcDialects.FanucMill);
        Assert.Equal(30_000, path.Motions.Length);
        Assert.Equal(29_999, path.Motions[^1].End.X);
    }

    [Fact]
    public void Numbers_without_a_point_are_counted_in_both_halves()
    {
        var note = Assert.Single(Bench.Read(Program(i => i % 2 == 0 ? "G1 X1. Y1." : "G1 X2 Y2.", Long), NcDialects.FanucMill).Notes);
        Assert.Equal(("number-without-point", 1, Long / 2L), (note.Code, note.Block, note.Count));
    }

    private static void AssertSame(Func<int, string> block)
    {
        var whole = Bench.Read(Program(block, Long), NcDialects.FanucMill);
        var part = Bench.Read(Program(block, Short), NcDialects.FanucMill);
        Assert.Equal(part.Problems, whole.Problems.Where(p => p.Block < Short));
        Assert.Equal(part.Frames, whole.Frames);
        Assert.InRange(part.Motions.Length, 1, whole.Motions.Length);
        for (var i = 0; i < part.Motions.Length; i++)
        {
            if (part.Motions[i] != whole.Motions[i])
            {
                Assert.Fail(Text($"Motion {i}: {part.Motions[i]} is {whole.Motions[i]}"));
            }
        }
    }

    private static string Program(Func<int, string> block, int blocks)
    {
        var text = new StringBuilder();
        for (var i = 0; i < blocks; i++)
        {
            text.Append(block(i)).Append('\n');
        }

        return text.ToString();
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
