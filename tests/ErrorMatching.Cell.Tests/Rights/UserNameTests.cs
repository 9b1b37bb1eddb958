namespace ErrorMatching.Cell.Tests;

public sealed class UserNameTests
{
    [Theory]
    [InlineData("a"), InlineData("anna"), InlineData("Anna Weber"), InlineData("a.weber@shop"), InlineData("ÄÖÜ ß é"), InlineData("李明"),
        InlineData("Ольга"), InlineData("1234567890123456789012345678901234567890123456789012345678901234")]
    public void A_name_of_printable_characters_is_one(string name) => UserName.Demand(name);

    [Theory]
    [InlineData(""), InlineData("12345678901234567890123456789012345678901234567890123456789012345"), InlineData(" "), InlineData(" anna"),
        InlineData("anna "), InlineData("an  na"), InlineData("--user")]
    [InlineData("an\tna"), InlineData("anna\n"), InlineData("an\0na"), InlineData("an\u001bna"), InlineData("an\u200bna"),
        InlineData("an\u202ena"), InlineData("an\u00a0na"), InlineData("e\u0301va"), InlineData("\ud83d\ude00"), InlineData("\ue000")]
    [InlineData("cell"), InlineData("Cell"), InlineData("CONSOLE"), InlineData("unknown")]
    public void Anything_else_is_none(string name) =>
        Assert.Equal(PeopleError.BadUserName, Assert.Throws<PeopleException>(() => UserName.Demand(name)).Error);

    [Theory]
    [InlineData("Anna", "aNNA"), InlineData("Öttl", "öTTL"), InlineData("Ольга", "ОЛЬГА")]
    public void Large_and_small_letters_are_the_same(string name, string other)
    {
        Assert.Equal(UserName.Key(name), UserName.Key(other));
        Assert.Equal(UserName.Hash(name), UserName.Hash(other));
    }

    [Fact]
    public void What_was_typed_for_a_name_is_not_kept_as_it_is() =>
        Assert.DoesNotContain("secret", UserName.Hash("my secret password"), StringComparison.OrdinalIgnoreCase);
}
