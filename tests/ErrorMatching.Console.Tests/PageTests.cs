namespace ErrorMatching.Console.Tests;

public class PageTests
{
    [Fact]
    public void Numbers_stand_right_and_text_left()
    {
        using var writer = new StringWriter();
        new Page(writer, hasColor: false).Table(["name", "mm"], [["a", "1.5"], ["longer", "-10.25"]]);
        Assert.Equal("name        mm\na          1.5\nlonger  -10.25\n", writer.ToString());
    }

    [Fact]
    public void Color_is_only_where_the_terminal_has_it()
    {
        using var writer = new StringWriter();
        new Page(writer, hasColor: true).Heading("Proof");
        Assert.Equal("\u001b[1mProof\u001b[0m\n", writer.ToString());
    }

    [Theory]
    [InlineData(false, null, "xterm", true)]
    [InlineData(false, "", null, true)]
    [InlineData(true, null, "xterm", false)]
    [InlineData(false, "1", "xterm", false)]
    [InlineData(false, "0", "xterm", false)]
    [InlineData(false, null, "dumb", false)]
    public void Color_needs_a_terminal_that_shows_it_and_nobody_against_it(
        bool isRedirected, string? noColor, string? terminal, bool color) =>
        Assert.Equal(color, Terminal.WantsColor(isRedirected, noColor, terminal));
}
