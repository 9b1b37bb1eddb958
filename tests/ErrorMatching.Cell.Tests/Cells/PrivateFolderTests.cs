using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>What a killed process left of its transfers is removed; what a living one has is not.</summary>
public sealed class PrivateFolderTests
{
    [Fact]
    public void Only_what_nobody_holds_is_removed()
    {
        using var temporary = new TemporaryFolder();
        var (left, held, other) = (temporary["errormatch-transfers-left"], temporary["errormatch-transfers-held"], temporary["other"]);
        foreach (var folder in new[] { left, held, other })
        {
            Directory.CreateDirectory(Path.Combine(folder, "deeper"));
            File.WriteAllText(Path.Combine(folder, "lock"), "");
            File.WriteAllText(Path.Combine(folder, "deeper", "program"), "G1 X1");
        }

        using (new FileStream(Path.Combine(held, "lock"), FileMode.Open, FileAccess.ReadWrite, FileShare.None))
        {
            PrivateFolder.Sweep(temporary.Path);
            Assert.Equal([held, other], Directory.GetDirectories(temporary.Path).Order(StringComparer.Ordinal));
        }

        PrivateFolder.Sweep(temporary.Path);
        Assert.Equal([other], Directory.GetDirectories(temporary.Path));
    }

    [Fact]
    public void A_folder_is_of_one_transfer_and_goes_with_it()
    {
        string path;
        using (var folder = new PrivateFolder())
        {
            File.WriteAllText(folder["program"], "G1 X1");
            path = Path.GetDirectoryName(folder["program"])!;
            using var another = new PrivateFolder();
            Assert.NotEqual(folder["program"], another["program"]);
            PrivateFolder.Sweep(Path.GetTempPath());
            Assert.True(File.Exists(folder["program"]));
            if (!OperatingSystem.IsWindows())
            {
                Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute, File.GetUnixFileMode(path));
            }
        }

        Assert.False(Directory.Exists(path));
    }
}
