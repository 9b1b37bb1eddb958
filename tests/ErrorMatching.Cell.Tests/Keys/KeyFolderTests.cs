namespace ErrorMatching.Cell.Tests;

public sealed class KeyFolderTests : PeopleTest
{
    private const UnixFileMode Owner = UnixFileMode.UserRead | UnixFileMode.UserWrite;

    [Fact]
    public void Only_its_owner_reaches_the_folder_and_what_is_in_it()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has lists of rights instead; there the keys are encrypted by DPAPI.");
        new AuditTrail(Store, Keys).Verify();
        Assert.Equal(Owner | UnixFileMode.UserExecute, Mode(Keys));
        var files = Directory.GetFiles(Keys);
        Assert.Equal(3, files.Length);
        Assert.All(files, f => Assert.Equal(Owner, Mode(f)));
    }

    [Theory]
    [InlineData(UnixFileMode.GroupRead), InlineData(UnixFileMode.GroupWrite), InlineData(UnixFileMode.OtherRead),
        InlineData(UnixFileMode.OtherExecute)]
    public void What_others_reach_is_refused_by_name(UnixFileMode more)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has lists of rights instead.");
        foreach (var path in Directory.GetFiles(Keys).Append(Keys))
        {
            var mode = Mode(path);
            Set(path, mode | more);
            Assert.Contains(path, Refused(PeopleError.KeysUnusable, () => AuditKey.Open(Keys)).Message, StringComparison.Ordinal);
            Set(path, mode);
        }

        Assert.Equal(Key, AuditKey.Open(Keys));
    }

    [Fact]
    public void A_file_in_the_folders_place_is_named()
    {
        File.WriteAllText(PathOf("file"), "");
        Assert.Contains(
            PathOf("file"), Refused(PeopleError.KeysUnusable, () => AuditKey.Open(PathOf("file"))).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_key_of_the_trail_stays_the_same()
    {
        Assert.Equal(32, Key.Length);
        Assert.Equal(Key, AuditKey.Open(Keys));
        Assert.Equal(Key, AuditKey.Find(Keys));
        Assert.NotEqual(Key, AuditKey.Open(PathOf("others")));
    }

    [Fact]
    public void Looking_for_a_key_makes_none()
    {
        Assert.Null(AuditKey.Find(PathOf("none")));
        Assert.False(Directory.Exists(PathOf("none")));
    }

    [Fact]
    public void Many_that_begin_at_once_have_one_key()
    {
        var keys = new byte[8][];
        Parallel.For(0, 8, i => keys[i] = AuditKey.Open(PathOf("begun")));
        Assert.All(keys, k => Assert.Equal(keys[0], k));
    }

    [Fact]
    public async Task A_file_that_vanishes_while_the_folder_is_looked_at_is_no_fault()
    {
        using var stop = new CancellationTokenSource();

        // As other processes write under names of their own, and rename those.
        var others = Task.Run(
            () =>
            {
                while (!stop.IsCancellationRequested)
                {
                    string[] files = [.. Enumerable.Range(0, 50).Select(i => Path.Combine(Keys, $"{i}.new"))];
                    foreach (var file in files)
                    {
                        Create(file);
                    }

                    foreach (var file in files)
                    {
                        File.Delete(file);
                    }
                }
            },
            TestContext.Current.CancellationToken);
        for (var i = 0; i < 300; i++)
        {
            Assert.NotEmpty(new KeyFolder(Keys).Read("audit.key"));
        }

        await stop.CancelAsync();
        await others;
    }

    [Fact]
    public void A_changed_key_of_the_trail_is_named()
    {
        var file = Path.Combine(Keys, "audit.key");
        var bytes = File.ReadAllBytes(file);
        bytes[^1] ^= 1;
        File.WriteAllBytes(file, bytes);
        Assert.Contains("audit.key", Refused(PeopleError.SecretUnreadable, () => AuditKey.Open(Keys)).Message, StringComparison.Ordinal);
    }

    private static UnixFileMode Mode(string path) => OperatingSystem.IsWindows() ? default : File.GetUnixFileMode(path);

    private static void Create(string path)
    {
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows())
        {
            options.UnixCreateMode = Owner;
        }

        using var file = new FileStream(path, options);
    }

    private static void Set(string path, UnixFileMode mode)
    {
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(path, mode);
        }
    }
}
