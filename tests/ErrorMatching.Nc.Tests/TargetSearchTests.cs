using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>The work of searching jump targets is measured by what is read, so that the limit of a program's work is one of time.</summary>
public sealed class TargetSearchTests
{
    private const int Blocks = 100;
    private static readonly FlowUnit Unit = new(null!, "", 0, Blocks + 1);

    [Theory]
    [InlineData(1)]
    [InlineData(10)]
    [InlineData(100)]
    public void A_long_head_is_as_much_work_as_short_ones(int times)
    {
        // Each head is as long as so many heads of usual length.
        var search = Search(string.Concat(Enumerable.Repeat(new string(' ', 64 * times) + "X1\n", Blocks)) + "N7\n");
        Assert.Equal(Blocks, search.Number(Unit, -1, 7, true, true));
        Assert.Equal((Blocks * (times + 1)) + 1, search.Count);

        // The same again is known.
        Assert.Equal(Blocks, search.Number(Unit, -1, 7, true, true));
        Assert.Equal((Blocks * (times + 1)) + 1, search.Count);
    }

    [Fact]
    public void A_search_backward_is_work_too()
    {
        var search = Search("N7\n" + string.Concat(Enumerable.Repeat(new string(' ', 640) + "X1\n", Blocks)));
        Assert.Equal(0, search.Number(Unit, Blocks, 7, false, true));
        Assert.Equal((11 * Blocks) + 1, search.Count);
    }

    // Each jump searches the long head at the end of the file for a target of its own.
    [Fact]
    public void A_program_whose_jumps_search_long_heads_is_refused_by_its_work()
    {
        var text = new StringBuilder("#1=0\nN9000 #1=#1+1\nIF[#1GT600]GOTO9999\nGOTO#1\n").Append(' ', 1_000_000).Append("X1\n");
        for (var i = 1; i <= 600; i++)
            text.Append(CultureInfo.InvariantCulture, $"N{i} GOTO9000\n");
        var program = NcProgram.Read(Encoding.ASCII.GetBytes(text.Append("N9999 M30\n").ToString()));
        var path = NcInterpreter.Run(program, NcDialects.Named("fanuc"));
        Assert.Equal(NcRefusalCodes.EndlessLoop, path.Refusal?.Code);
    }

    private static TargetSearch Search(string text) => new(NcProgram.Read(Encoding.ASCII.GetBytes(text)), NcSyntax.Iso, skips: false);
}
