using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Json.Tests;

public sealed class RefusalTests
{
    [Fact]
    public void The_example_of_the_readme_of_refusals_runs()
    {
        // example
        var refusal = new Refusal("unknown-key", "The key \"gian\" is not known here; did you mean \"gain\"?",
            new InputPlace { File = "job.json", Line = 2, Column = 3, Path = "$.gian" });
        var sentence = refusal.Sentence;
        // example

        var readme = File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Refusals", "README.md"));
        Assert.Contains($"`{sentence}`", readme, StringComparison.Ordinal);
        var source = File.ReadAllText(Repository.PathTo("tests", "ErrorMatching.Json.Tests", "RefusalTests.cs"));
        var lines = source.Split("        // example\n")[1].Split('\n').Select(l => l.Length > 8 ? l[8..] : "");
        Assert.Contains(string.Join('\n', lines), readme, StringComparison.Ordinal);
    }

    // The message of a block names the block; a file that the message names stands there once.
    [Theory]
    [InlineData("p.nc", null, "N110", "N110: no.", "p.nc: N110: no.")]
    [InlineData("p.nc", 12, "line 12", "line 12: no.", "p.nc: line 12: no.")]
    [InlineData("p.nc", null, null, "p.nc cannot be opened.", "p.nc cannot be opened.")]
    [InlineData("p.nc", 3, null, "no p.nc.", "p.nc, line 3: no p.nc.")]
    [InlineData(null, 3, null, "no.", "line 3: no.")]
    [InlineData(null, null, null, "no.", "no.")]
    public void The_sentence_names_the_place_once(string? file, int? line, string? block, string message, string expected)
    {
        var refusal = new Refusal("no-good", message, new() { File = file, Line = line, Block = block });
        Assert.Equal(expected, refusal.Sentence);
        Assert.Equal(expected, new InputException(refusal).Message);
    }

    [Fact]
    public void A_file_is_added_only_where_none_is_named()
    {
        var refusal = new Refusal("no-good", "no.");
        Assert.Equal("a: no.", refusal.In("a").Sentence);
        Assert.Equal("a: no.", refusal.In("a").In("b").Sentence);
    }

    [Fact]
    public void An_exception_without_a_reason_cannot_be_made() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new InputException([]));
}
