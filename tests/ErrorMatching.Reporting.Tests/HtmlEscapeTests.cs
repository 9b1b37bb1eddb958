using System.Text;

namespace ErrorMatching.Reporting.Tests;

/// <summary>What a page shows of text from elsewhere.</summary>
public sealed class HtmlEscapeTests
{
    [Theory]
    [InlineData("", "")]
    [InlineData("N10 G1 X1.5", "N10 G1 X1.5")]
    [InlineData("<b>&\"'</b>", "&lt;b&gt;&amp;&quot;&#39;&lt;/b&gt;")]
    [InlineData("a<", "a&lt;")]
    [InlineData("µm Ø6 \U0001F600!", "µm Ø6 \U0001F600!")]
    [InlineData("tab\tline\r\nend", "tab line  end")]
    [InlineData("bell\a, delete\u007F, C1\u0085", "bell\uFFFD, delete\uFFFD, C1\uFFFD")]
    [InlineData("turn\u202Eround", "turn[U+202E]round")]
    [InlineData("not a character \uFFFE", "not a character \uFFFD")]
    public void Text_is_shown_and_never_obeyed(string text, string escaped) => Assert.Equal(escaped, Escaped(text));

    [Fact]
    public void A_lone_surrogate_becomes_the_replacement_character() =>
        Assert.Equal("\uFFFD and \uFFFD", Escaped($"{(char)0xD83D} and {(char)0xDE00}"));

    private static string Escaped(string text)
    {
        var target = new StringBuilder();
        HtmlEscape.Append(target, text);
        return target.ToString();
    }
}
