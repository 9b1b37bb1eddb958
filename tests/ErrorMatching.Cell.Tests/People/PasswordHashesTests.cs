using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class PasswordHashesTests
{
    // OWASP Password Storage Cheat Sheet (2025): PBKDF2-HMAC-SHA512: 220,000 iterations.
    private const int Owasp = 220_000;

    [Fact]
    public void A_hash_is_PBKDF2_of_HMAC_SHA_512_at_the_work_factor_of_OWASP()
    {
        var hash = Convert.FromBase64String(new PasswordHashes().Of("correct horse battery"));
        Assert.Equal((1, 2, Owasp, 16, 61), (hash[0], Number(hash, 1), Number(hash, 5), Number(hash, 9), hash.Length));
        Assert.Equal(
            Rfc2898DeriveBytes.Pbkdf2(
                Encoding.UTF8.GetBytes("correct horse battery"), hash.AsSpan(13, 16), Owasp, HashAlgorithmName.SHA512, 32),
            hash[29..]);
    }

    [Fact]
    public void Two_hashes_of_one_password_differ() => Assert.NotEqual(new PasswordHashes(10).Of("a"), new PasswordHashes(10).Of("a"));

    [Fact]
    public void Only_the_password_is_right()
    {
        var hashes = new PasswordHashes(10);
        var hash = hashes.Of("correct horse battery");
        Assert.Equal((true, false), hashes.Compare(hash, "correct horse battery"));
        Assert.False(hashes.Compare(hash, "correct horse batterY").IsRight);
        Assert.False(hashes.Compare(hash, "").IsRight);
        Assert.False(hashes.Compare(hash, "correct horse battery ").IsRight);
    }

    [Fact]
    public void A_hash_of_less_work_is_right_and_stale()
    {
        var hash = new PasswordHashes(10).Of("correct horse battery");
        Assert.Equal((true, true), new PasswordHashes(11).Compare(hash, "correct horse battery"));
    }

    [Fact]
    public void Nobodys_hash_takes_as_much_work_and_has_no_password()
    {
        var hashes = new PasswordHashes();
        var hash = Convert.FromBase64String(hashes.Nobodys);
        Assert.Equal((1, 2, Owasp, 16, 61), (hash[0], Number(hash, 1), Number(hash, 5), Number(hash, 9), hash.Length));
        Assert.False(hashes.Compare(null, "").IsRight);
        Assert.False(hashes.Compare(null, "correct horse battery").IsRight);
    }

    [Theory]
    [InlineData(""), InlineData("AQ=="), InlineData("not base 64"), InlineData("AQAAAAIAA1tgAAAAEA==")]
    public void What_is_no_hash_is_nobodys_password(string hash) =>
        Assert.False(new PasswordHashes(10).Compare(hash, "correct horse battery").IsRight);

    [Fact]
    public void A_megabyte_is_no_password() =>
        Assert.False(new PasswordHashes(10).Compare(new PasswordHashes(10).Of(new string('a', 1 << 20)), new string('a', 1 << 20)).IsRight);

    private static int Number(byte[] hash, int at) => BinaryPrimitives.ReadInt32BigEndian(hash.AsSpan(at));
}
