using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class MachineSecretsTests : PeopleTest
{
    private const string Secret = "s3cret of the mill äöü 密";

    private MachineSecrets Secrets => new(Store, Keys);

    [Fact]
    public void A_secret_comes_back_in_another_process()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Assert.Equal(Secret, Secrets.Get("vmc1"));
        Assert.Null(Secrets.Get("vmc2"));
        Assert.Equal("Anna secret-set vmc1", Trail[^1]);
    }

    [Fact]
    public void A_new_one_takes_its_place()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Secrets.Set("vmc1", "another", "Anna");
        Assert.Equal("another", Secrets.Get("vmc1"));
    }

    [Fact]
    public void A_removed_one_is_gone()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Assert.True(Secrets.Remove("vmc1", "Ben"));
        Assert.Null(Secrets.Get("vmc1"));
        Assert.Equal("Ben secret-removed vmc1", Trail[^1]);
        Assert.False(Secrets.Remove("vmc1", "Ben"));
    }

    [Theory]
    [InlineData(""), InlineData("a\nb"), InlineData("a\tb"), InlineData("a\0")]
    public void What_no_control_takes_is_none(string secret) => Refused(PeopleError.BadSecret, () => Secrets.Set("vmc1", secret, "Anna"));

    [Fact]
    public void The_longest_has_1024_characters()
    {
        Secrets.Set("vmc1", new string('a', 1024), "Anna");
        Refused(PeopleError.BadSecret, () => Secrets.Set("vmc1", new string('a', 1025), "Anna"));
    }

    [Fact]
    public void Neither_store_nor_trail_nor_keys_show_it()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Store.Backup(PathOf("copy.db"));
        foreach (var file in Directory.EnumerateFiles(Keys).Append(PathOf("copy.db")))
        {
            Assert.DoesNotContain("s3cret", Encoding.Latin1.GetString(File.ReadAllBytes(file)), StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Moved_to_another_machine_it_is_not_decrypted()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Store.Write(t => t.Execute("INSERT INTO machine_secret SELECT 'vmc2', bytes FROM machine_secret"));
        var refusal = Refused(PeopleError.SecretUnreadable, () => Secrets.Get("vmc2"));
        Assert.Contains("vmc2", refusal.Message, StringComparison.Ordinal);
        Assert.Equal(Secret, Secrets.Get("vmc1"));
    }

    [Fact]
    public void A_byte_that_was_changed_is_found_wherever_it_is()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        var bytes = Store.Read("SELECT bytes FROM machine_secret", r => (byte[])r.GetValue(0))[0];
        var secrets = Secrets;
        for (var at = 0; at < bytes.Length; at++)
        {
            var changed = bytes.ToArray();
            changed[at] ^= 1;
            Store.Write(t => t.Execute("UPDATE machine_secret SET bytes = @changed", [("changed", changed)]));
            Refused(PeopleError.SecretUnreadable, () => secrets.Get("vmc1"));
        }

        Store.Write(t => t.Execute("UPDATE machine_secret SET bytes = @cut", [("cut", bytes[..^1])]));
        Refused(PeopleError.SecretUnreadable, () => secrets.Get("vmc1"));
        Store.Write(t => t.Execute("UPDATE machine_secret SET bytes = @bytes", [("bytes", bytes)]));
        Assert.Equal(Secret, secrets.Get("vmc1"));
    }

    [Fact]
    public void Keys_of_another_installation_do_not_read_it()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        Refused(PeopleError.SecretUnreadable, () => new MachineSecrets(Store, PathOf("others")).Get("vmc1"));
    }

    [Fact]
    public void Copied_keys_read_it()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        AuditKey.Open(PathOf("copied"));
        foreach (var file in Directory.EnumerateFiles(Keys))
        {
            File.Copy(file, Path.Combine(PathOf("copied"), Path.GetFileName(file)), overwrite: true);
        }

        Assert.Equal(Secret, new MachineSecrets(Store, PathOf("copied")).Get("vmc1"));
        Assert.Equal(Key, AuditKey.Find(PathOf("copied")));
    }

    [Fact]
    public void Keys_that_are_no_XML_are_named()
    {
        Secrets.Set("vmc1", Secret, "Anna");
        var file = Directory.EnumerateFiles(Keys, "*.xml").First();
        File.WriteAllText(file, "<key");
        Assert.Contains(file, Refused(PeopleError.KeysUnusable, () => Secrets.Get("vmc1")).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("<key/>"), InlineData("<revocation version=\"1\"><key id=\"*\"/></revocation>"),
        InlineData("<key id=\"x\" version=\"1\"/>"), InlineData("<a/>")]
    public void Keys_that_are_something_else_do_not_read_it(string text)
    {
        Secrets.Set("vmc1", Secret, "Anna");
        File.WriteAllText(Directory.EnumerateFiles(Keys, "*.xml").First(), text);
        Assert.Contains(
            Assert.Throws<PeopleException>(() => Secrets.Get("vmc1")).Error,
            new[] { PeopleError.SecretUnreadable, PeopleError.KeysUnusable });
    }
}
