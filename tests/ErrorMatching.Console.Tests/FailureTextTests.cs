using ErrorMatching.Refusals;

namespace ErrorMatching.Console.Tests;

public sealed class FailureTextTests
{
    // The text form puts file and line in front: a block that is named by its line must not say it again.
    [Theory]
    [InlineData("line 3", "line 3: no good.", "p.nc:3: no good.")]
    [InlineData("N30", "N30: no good.", "p.nc:3: N30: no good.")]
    [InlineData("line 30", "line 30: no good.", "p.nc:3: line 30: no good.")]
    public void A_line_that_stands_in_the_place_does_not_stand_in_the_message(string block, string message, string expected) =>
        Assert.Equal(expected + "\n", Written(new("no-good", message, new() { File = "p.nc", Block = block, Line = 3 })));

    [Fact]
    public void A_message_about_a_whole_file_names_it_once()
    {
        Assert.Equal("errormatch: p.nc cannot be read.\n", Written(new("no-good", "p.nc cannot be read.", new() { File = "p.nc" })));
        Assert.Equal("p.nc: not a program.\n", Written(new("no-good", "not a program.", new() { File = "p.nc" })));
        Assert.Equal("errormatch: no file.\n", Written(new("no-good", "no file.")));
    }

    [Fact]
    public void A_place_in_a_document_has_line_column_and_path() => Assert.Equal(
        "job.json:3:5:$.nmae: found the key nmae; expected one of name.\n",
        Written(Refusal.Of(
            "no-such-key", "the key nmae", "one of name", new() { File = "job.json", Line = 3, Column = 5, Path = "$.nmae" })));

    private static string Written(Refusal refusal)
    {
        var error = new StringWriter();
        var terminal = new Terminal(new StringWriter(), error, HasColor: false);
        Assert.Equal(ExitCode.Refused, OutcomeWriter.Write(new Failure(ExitCode.Refused, refusal), terminal, isJson: false));
        return error.ToString();
    }
}
