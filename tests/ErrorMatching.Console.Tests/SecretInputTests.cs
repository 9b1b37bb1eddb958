namespace ErrorMatching.Console.Tests;

public sealed class SecretInputTests
{
    [Fact]
    public void Keys_are_not_shown()
    {
        using var shown = new StringWriter();
        var input = new SecretInput(TextReader.Null, CellFolder.Keyboard("abc\bd\u001b\0\n"), shown);
        Assert.Equal("abd", input.Ask("password of anna", fromInput: false));
        Assert.Equal("Password of anna: \n", shown.ToString());
    }

    [Fact]
    public void A_new_one_is_typed_twice()
    {
        Assert.Equal("abc", Typing("abc\nabc\n").AskNew("new password", fromInput: false));
        Assert.Contains(
            "differ",
            Assert.Throws<SecretInputException>(() => Typing("abc\nabd\n").AskNew("new password", fromInput: false)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Deleting_what_is_not_there_is_nothing() => Assert.Equal("a", Typing("\b\ba\n").Ask("password", fromInput: false));

    [Theory]
    [InlineData("one\ntwo\n"), InlineData("one\r\ntwo\r\n"), InlineData("one\ntwo")]
    public void Each_line_is_one(string text)
    {
        var input = new SecretInput(new StringReader(text), null, TextWriter.Null);
        Assert.Equal(("one", "two"), (input.Ask("password", fromInput: true), input.AskNew("new password", fromInput: true)));
        Assert.Contains(
            "new password",
            Assert.Throws<SecretInputException>(() => input.Ask("new password", fromInput: true)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void A_terminal_asks_even_where_lines_were_meant() => Assert.Equal("abc", Typing("abc\n").Ask("password", fromInput: true));

    [Fact]
    public void Lines_are_not_read_unless_that_is_said()
    {
        var touched = false;
        var input = new SecretInput(
            new Lazy<TextReader>(() =>
            {
                touched = true;
                return TextReader.Null;
            }),
            null,
            TextWriter.Null);
        Assert.Contains(
            "--password-stdin",
            Assert.Throws<SecretInputException>(() => input.Ask("password", fromInput: false)).Message,
            StringComparison.Ordinal);
        Assert.False(touched);
    }

    [Fact]
    public void A_line_without_end_is_refused() =>
        Assert.Throws<SecretInputException>(
            () => new SecretInput(new StringReader(new string('a', 1 << 20)), null, TextWriter.Null).Ask("password", fromInput: true));

    private static SecretInput Typing(string keys) => new(TextReader.Null, CellFolder.Keyboard(keys), TextWriter.Null);
}
