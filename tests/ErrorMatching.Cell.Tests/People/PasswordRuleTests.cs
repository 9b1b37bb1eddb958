namespace ErrorMatching.Cell.Tests;

public sealed class PasswordRuleTests
{
    [Theory]
    [InlineData("correct horse battery"), InlineData("staple of the ox"), InlineData("kX9#vPq2!mZr"), InlineData("annas garten im mai"),
        InlineData("пароль не угадать"), InlineData("zwölf Zeichen"), InlineData("999 Luftballons!")]
    public void Long_ones_that_nobody_guesses_are_taken(string password) => PasswordRule.Demand("anna", password);

    [Fact]
    public void The_shortest_has_12_characters_and_the_longest_256()
    {
        PasswordRule.Demand("anna", "mZrkX9#vPq2!");
        Weak("anna", "mZrkX9#vPq2");
        Weak("anna", "");
        var longest = string.Concat(Enumerable.Range(0, 256).Select(i => (char)('a' + (i * i * i / 7 % 23))));
        PasswordRule.Demand("anna", longest);
        Weak("anna", longest + "b");
    }

    [Theory]
    [InlineData("annaweberanna"), InlineData("AnnaWeberAnna"), InlineData("annaweberannaAnnaWeberAnna"), InlineData("annaweberanna2026!")]
    public void The_name_is_none(string password) => Weak("annaweberanna", password);

    [Theory]
    [InlineData("anna12345678"), InlineData("1234567Anna!"), InlineData("AnnaAnnaAnna"), InlineData("2026 @nna 2027")]
    public void Nor_is_it_with_digits_and_signs(string password) => Weak("anna", password);

    [Theory]
    [InlineData("password1234"), InlineData("Password123!"), InlineData("p4ssw0rd2026"), InlineData("P@$$w0rd1234"),
        InlineData("passwordpassword"), InlineData("Passwort2026!"), InlineData("qwertyuiop12"), InlineData("qwertz123456")]
    [InlineData("123456789012"), InlineData("111111111111"), InlineData("abcabcabcabc"), InlineData("abcdefghijkl"),
        InlineData("987654321098"), InlineData("administrator"), InlineData("Administrator1"), InlineData("letmein12345"),
        InlineData("errormatching")]
    [InlineData("fanuc1234567"), InlineData("welcome2026!"), InlineData("............"), InlineData("iloveyou2026")]
    public void What_is_tried_first_is_none(string password) => Weak("ben", password);

    [Theory]
    [InlineData("Winter2026!!"), InlineData("!Summer-2026!"), InlineData("Herbst.2025.."), InlineData("W1nter2026!!")]
    [InlineData("Winter2026Ben"), InlineData("ben.Monday.2026"), InlineData("Summer25Winter26"), InlineData("2026-Password-Mai")]
    public void Nor_is_what_the_calendar_says(string password)
    {
        Weak("ben", password);
        Assert.Contains(
            "season", Assert.Throws<PeopleException>(() => PasswordRule.Demand("ben", password)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("winter rain over lathes"), InlineData("three seasons of 2026"), InlineData("april, monkey and haas")]
    public void A_word_of_the_calendar_among_others_is_taken(string password) => PasswordRule.Demand("ben", password);

    [Fact]
    public void Control_characters_are_none() => Weak("anna", "correct\thorse battery");

    [Fact]
    public void The_refusal_does_not_show_it() =>
        Assert.DoesNotContain(
            "P@$$w0rd1234",
            Assert.Throws<PeopleException>(() => PasswordRule.Demand("anna", "P@$$w0rd1234")).Message,
            StringComparison.Ordinal);

    private static void Weak(string name, string password) =>
        Assert.Equal(PeopleError.WeakPassword, Assert.Throws<PeopleException>(() => PasswordRule.Demand(name, password)).Error);
}
