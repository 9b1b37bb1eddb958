using System.Runtime.CompilerServices;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>The package's README: its example is the code between the markers below, and its result is what the example gives.</summary>
public sealed class ReadMeTests
{
    [Fact]
    public void Example_gives_the_result_that_the_README_shows()
    {
        // example
        var program = NcProgram.FromText("""
            N10 G21 G90 G17 G0 X0. Y0. (counterpart)
            N20 G1 X10. Y0. F300
            N30 X10. Y10.
            N40 X0. Y10.
            """);
        var path = NcInterpreter.Run(program, NcDialects.Named("fanuc"));
        var blocks = BlockSelector.Select(program, [BlockSelector.Parse("N20..N30")]);
        if (!blocks.IsUsable)
        {
            throw new InvalidOperationException(blocks.Refusal.Message);
        }

        var wish = DisplacementWish.Normal(path, blocks.Result, left: 0.1);
        var rewrite = Rewriter.Apply(path, wish.Result!);
        var proof = Prover.Check(path, rewrite.Result!.Program, wish.Result!, rewrite.Result.LeastIncrementMm);
        // example

        Assert.True(proof.Holds);
        Assert.Equal((4, 3), (rewrite.Result.ChangedWords, rewrite.Result.ChangedBlocks.Count));
        Assert.Equal([("N10", NeighborRole.Positioning), ("N40", NeighborRole.Slides)], proof.Neighbors.Select(n => (n.Block, n.Role)));
        var readMe = File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Nc", "README.md"));
        Assert.Contains("```text\n" + Bench.Text(rewrite.Result.Program) + "\n```", readMe, StringComparison.Ordinal);
    }

    [Fact]
    public void Example_of_the_README_is_the_one_that_runs()
    {
        var lines = File.ReadAllLines(ThisFile()).ToList();
        var (first, last) = (lines.FindIndex(l => l.Trim() == "// example"), lines.FindLastIndex(l => l.Trim() == "// example"));
        var example = string.Join('\n', lines[(first + 1)..last].Select(l => l.Length > 8 ? l[8..] : l));
        Assert.Contains(
            "```csharp\n" + example + "\n```",
            File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Nc", "README.md")),
            StringComparison.Ordinal);
    }

    private static string ThisFile([CallerFilePath] string path = "") =>
        File.Exists(path) ? path : Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "ReadMeTests.cs");
}
