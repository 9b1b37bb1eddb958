using System.Globalization;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// Random blocks, half of them with one fault, and what LinuxCNC's own interpreter says of each: a block that it refuses is named here,
/// and one that it accepts is not. <c>ERRORMATCH_PEER_BLOCKS</c> sets how many (200 if not set), <c>ERRORMATCH_PEER_SEED</c> the first
/// seed.
/// </summary>
public sealed class RefusalAgreementTests
{
    private const double LeastAgreement = 0.99;

    private static readonly int Blocks = Setting("ERRORMATCH_PEER_BLOCKS", 200);
    private static readonly int FirstSeed = Setting("ERRORMATCH_PEER_SEED", 1);

    [Fact]
    public void What_rs274_refuses_is_named()
    {
        Rs274.IsNeeded();
        RandomBlock[] blocks = [.. Enumerable.Range(0, Blocks).Select(i => RandomBlock.Write(FirstSeed + (i / 2), isFaulty: i % 2 == 1))];
        var peer = Rs274.RunBlocks(RandomBlock.Reset, [.. blocks.Select(b => (b.Before, b.Text))]);

        var (refused, differences, unnamed) = (0, new List<string>(), 0);
        foreach (var (block, said) in blocks.Zip(peer))
        {
            refused += said is not null ? 1 : 0;
            var found = Findings(RandomBlock.Reset, block.Before, block.Text);
            if (found.Count > 0 != said is not null || found.Any(f => f.Line != Line(RandomBlock.Reset, block.Before)))
            {
                unnamed += said is not null ? 1 : 0;
                differences.Add($"\"{string.Join(" | ", [.. block.Before, block.Text])}\" ({block.Fault}): rs274 says {said ?? "nothing"}, "
                    + $"we say {string.Join(" ", found.Select(f => $"{f.Line}: {f.Message}"))}");
            }
        }

        var share = 1 - ((double)differences.Count / Blocks);
        TestContext.Current.TestOutputHelper?.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{share:P2} of {Blocks} blocks agree; rs274 refuses {refused}, of which {unnamed} are not named."));
        Assert.InRange(refused, Blocks / 3, Blocks * 2 / 3);
        Assert.True(share >= LeastAgreement, string.Join('\n', differences));
    }

    // O words change what the interpreter reads next, so each program runs by itself.
    [Theory]
    [InlineData("o100 sub\no101 sub\no101 endsub\no100 endsub\no100 call")]
    [InlineData("o100 sub\nG0 X1\no100 endsub\no100 call")]
    [InlineData("o100 endsub")]
    [InlineData("o100 call")]
    [InlineData("o100 if [1 GT 0]\nG0 X1\no101 endif")]
    [InlineData("o100 if [1 GT 0]\nG0 X1\no100 endif")]
    [InlineData("o100 if 1\no100 endif")]
    [InlineData("o100 repeat [2]\nG0 X1\no100 endrepeat")]
    [InlineData("o100 else")]
    [InlineData("o100 endwhile")]
    [InlineData("o100 break")]
    [InlineData("o100 foo")]
    [InlineData("o<name> sub\no<name> endsub\no<name> call [1] [2] extra")]
    [InlineData("o<name> sub\no<name> return [1]\no<name> endsub\no<name> call [1] [2]")]
    public void Programs_with_O_words_are_refused_where_rs274_refuses_them(string program)
    {
        Rs274.IsNeeded();
        var peer = Rs274.Run(program + "\nM2\n");
        var path = NcInterpreter.Run(NcProgram.FromText(program + "\nM2\n", NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc);

        Assert.True(peer.Refusal is null == (path.Refusal is null && path.Problems.Count == 0),
            $"rs274: {peer.Refusal}; we: {path.Refusal}");
    }

    private static List<(int Line, string Message)> Findings(IReadOnlyList<string> reset, IReadOnlyList<string> before, string block)
    {
        var text = string.Join('\n', [.. reset, .. before, block, "M2", ""]);
        var path = NcInterpreter.Run(NcProgram.FromText(text, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc);
        return [
            .. path.Problems.Select(p => (p.Block + 1, p.Message)),
            .. path.Refusal is { } refusal ? [(refusal.Place.Line ?? 0, refusal.Message)] : Array.Empty<(int, string)>()];
    }

    private static int Line(IReadOnlyList<string> reset, IReadOnlyList<string> before) => reset.Count + before.Count + 1;

    private static int Setting(string name, int otherwise) =>
        Environment.GetEnvironmentVariable(name) is { } text ? int.Parse(text, CultureInfo.InvariantCulture) : otherwise;
}
