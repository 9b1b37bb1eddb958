namespace ErrorMatching.Jobs.Tests;

public sealed class PrintedTextTests
{
    [Theory]
    [InlineData("part 1 \u00e4\u4e2d.csv", "part 1 \u00e4\u4e2d.csv")]
    [InlineData("a\r\nb\tc", "a\\r\\nb\\tc")]
    [InlineData("\u001b[31mred\u0007\u009b", "\\u001b[31mred\\u0007\\u009b")]
    [InlineData("gpj.\u202Evsc\u200b\u2028\ufeff", "gpj.\\u202evsc\\u200b\\u2028\\ufeff")]
    public void What_steers_a_terminal_is_shown_and_steers_nothing(string text, string shown) =>
        Assert.Equal(shown, PrintedText.OneLine(text));
}
