namespace ErrorMatching.Json.Tests;

public sealed class ContentHashTests
{
    // FIPS 180-4 (examples published by NIST): no bytes, and "abc".
    [Theory]
    [InlineData("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855")]
    [InlineData("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")]
    public void A_hash_is_that_of_the_standard(string text, string expected)
    {
        Assert.Equal(expected, ContentHash.Sha256OfText(text));
        Assert.Equal(expected, ContentHash.Sha256([.. text.Select(c => (byte)c)]));
    }

    [Fact]
    public void Text_is_hashed_in_UTF_8() => Assert.Equal(ContentHash.Sha256([0xC3, 0xA4]), ContentHash.Sha256OfText("ä"));
}
