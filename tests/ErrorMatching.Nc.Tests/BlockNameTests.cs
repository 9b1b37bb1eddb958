using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

public sealed class BlockNameTests
{
    private const string Program =
        "%\nN10 G0 X0\n(LINE)\nN20 G1 X5.\nN30 X6.\nG1 X7.\nX8.\nN40 X9.\nX8.\nN50 M30\nN50 M30\n\nX10. (A/B+C)\n%\n";

    [Theory]
    [InlineData(1, 1, "N10")]
    [InlineData(3, 4, "N20..N30")]
    [InlineData(2, 4, "/^\\(LINE\\)$/ N20..N30")]
    [InlineData(3, 5, "N20..N30 /^G1\\ X7\\.$/")]
    [InlineData(5, 5, "/^G1\\ X7\\.$/")]
    [InlineData(12, 12, "/^X10\\.\\ \\(A/B\\+C\\)$/")]
    [InlineData(6, 6, "L7")]
    [InlineData(9, 9, "L10")]
    [InlineData(11, 11, "L12")]
    [InlineData(5, 6, "L6..L7")]
    public void Blocks_are_named_by_their_numbers_else_by_their_text_and_by_their_lines_where_others_read_the_same(
        int first, int last, string words) =>
        Assert.Equal(words, string.Join(' ', BlockNames.Of(NcProgram.FromText(Program), first, last)));

    [Fact]
    public void What_is_named_is_what_is_read()
    {
        var line = Gen.Choose(0, 30).Zip(
            Gen.Choose(0, 5),
            (number, kind) => kind switch { 0 => $"X{number}.", 1 => "", 2 => $"N0{number}0", _ => $"N{10 * number} X{number}." });
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(1000),
            Prop.ForAll(Gen.NonEmptyListOf(line).Zip(Gen.Choose(0, 1000).Two()).ToArbitrary(), p =>
            {
                var program = NcProgram.FromText(string.Join('\n', p.Item1) + "\n");
                var (a, b) = (p.Item2.Item1 % program.BlockCount, p.Item2.Item2 % program.BlockCount);
                var (first, last) = (Math.Min(a, b), Math.Max(a, b));
                return BlockSelector.Select(
                    program,
                    [.. BlockNames.Of(program, first, last).Select(BlockSelector.Parse)]).Result!
                    .SequenceEqual(Enumerable.Range(first, last - first + 1));
            }));
    }

    [Fact]
    public void A_long_range_without_numbers_near_its_ends_is_named_by_its_lines()
    {
        var program = NcProgram.FromText(string.Join('\n', Enumerable.Range(0, 200).Select(i => i == 100 ? "N1 X100." : $"X{i}.")));
        Assert.Equal(["L1..L200"], BlockNames.Of(program, 0, 199));
        Assert.Equal(["L101..L200"], BlockNames.Of(program, 100, 199));
        Assert.Equal(["L2..L101"], BlockNames.Of(program, 1, 100));
        Assert.Equal(41, BlockNames.Of(program, 80, 120).Length);
    }
}
