using System.Diagnostics;
using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>A store in a file, as it is installed: its account owns store and keys, and people's accounts are in its group. Another account
/// sees, and can neither decide by itself nor take or delete anything.</summary>
public sealed class OtherAccountTests : IDisposable
{
    // Users and a group that nobody has: numbers are enough.
    private const string OfCell = "54310";
    private const string OfPerson = "54333";
    private const string Stranger = "54334";
    private const string Group = "54320";
    private readonly TemporaryFolder _folder = new();
    private readonly FireCell _cell = new(slots: 1);

    private string[] Reject => ["cell", "reject", _cell.Configuration, "1", "--user", "ben", "--reason", "no", "--password-stdin"];

    public void Dispose()
    {
        _cell.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public void A_person_of_the_group_sees_and_can_neither_decide_nor_take_the_keys_nor_delete_the_store()
    {
        Install();

        var (exit, history, said) = As(OfPerson, Group, ConsoleRun.Executable, "cell", "history", _cell.Configuration);
        Assert.True(exit == 0, said);
        Assert.Contains("17.csv", history, StringComparison.Ordinal);
        (exit, var shown, said) = As(OfPerson, Group, ConsoleRun.Executable, "cell", "show", _cell.Configuration, "1");
        Assert.True(exit == 0, said);
        Assert.Contains("failed", shown, StringComparison.Ordinal);

        // It is told that it may not read the key, and not that the key is gone.
        (exit, _, said) = As(OfPerson, Group, ConsoleRun.Executable, "audit", "verify", _cell.Configuration);
        Assert.Equal(2, exit);
        Assert.Contains($"This account may not read {_cell["keys"]}/audit.key", said, StringComparison.Ordinal);

        var before = File.ReadAllBytes(_cell["store", "cell.db"]);
        (exit, _, said) = As(OfPerson, Group, [ConsoleRun.Executable, .. Reject]);
        Assert.True(exit is 2 or 3, said);
        foreach (var taken in new[]
        {
            $"cat {_cell["keys"]}/audit.key", $"ls {_cell["keys"]}", $"rm -f {_cell["store"]}/cell.db", $"touch {_cell["store"]}/x",
            $"echo x >> {_cell["store"]}/cell.db", $"mv {_cell["keys"]} {_cell["keys"]}2",
        })
        {
            (exit, var output, said) = As(OfPerson, Group, "sh", "-c", taken);
            Assert.True(exit != 0 && said.Contains("ermission denied", StringComparison.Ordinal), $"{taken}: {output}{said}");
        }

        Assert.Equal(before, File.ReadAllBytes(_cell["store", "cell.db"]));
    }

    [Fact]
    public void The_cells_own_account_decides_and_a_stranger_sees_nothing()
    {
        Install();

        var (exit, _, said) = As(Stranger, Stranger, ConsoleRun.Executable, "cell", "history", _cell.Configuration);
        Assert.True(exit != 0, said);
        (exit, _, said) = As(OfCell, Group, [ConsoleRun.Executable, .. Reject]);
        Assert.True(exit == 0, said);

        // What it wrote is still the group's to read.
        (exit, var history, said) = As(OfPerson, Group, ConsoleRun.Executable, "cell", "history", _cell.Configuration);
        Assert.True(exit == 0 && history.Contains("rejected", StringComparison.Ordinal), said);
    }

    // A cell that has run, with one correction that waits for a decision, and the rights of docs/users-and-rights.md.
    private void Install()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux() && Environment.IsPrivilegedProcess, "Only root can be other users.");
        var settings = CellSettingsReader.Read(_cell.Configuration);
        using (var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.OpenFor(settings)))
        {
            new UserBook(store, TimeProvider.System, new PasswordHashes(10)).AddFirst("ben", "correct horse battery");
            var (arrived, _) = store.Archive(new Arrival("cmm", "17.csv", "17.csv", "points"u8.ToArray()));
            store.Step(arrived, CorrectionState.Failed, "cell", "the disk was full");
            new AuditTrail(store, settings.KeysFolder).Remember();
        }

        Directory.CreateDirectory(_cell["logs"]);
        Run("chmod", "755", _cell.Folder);
        Run("chown", "-R", $"{OfCell}:{Group}", _cell["store"], _cell["keys"], _cell["logs"], _cell.Incoming, _cell.Machine);
        Run("chmod", "750", _cell["store"], _cell["logs"]);
        Run("chmod", "640", _cell["store", "cell.db"]);
        var reach = As(OfPerson, Group, "test", "-x", ConsoleRun.Executable).Exit;
        Assert.SkipUnless(reach == 0, "Other users cannot reach the built console.");
    }

    private static (int Exit, string Output, string Said) As(string user, string group, params string[] command) => Start(
        "setpriv", [$"--reuid={user}", $"--regid={group}", "--clear-groups", "--no-new-privs", "env", "-C", "/", "HOME=/tmp", .. command]);

    private static void Run(string program, params string[] arguments) => Assert.Equal(0, Start(program, arguments).Exit);

    private static (int Exit, string Output, string Said) Start(string program, string[] arguments)
    {
        using var process = Process.Start(new ProcessStartInfo(program, arguments)
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        })!;
        if (arguments.Contains("--password-stdin"))
        {
            process.StandardInput.Write("correct horse battery\n");
        }

        process.StandardInput.Close();
        var (output, error) = (process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync());
        process.WaitForExit();
        return (process.ExitCode, output.GetAwaiter().GetResult(), error.GetAwaiter().GetResult());
    }
}
