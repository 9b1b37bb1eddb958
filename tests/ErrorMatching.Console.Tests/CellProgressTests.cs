using System.Text.RegularExpressions;
using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

/// <summary>Long work on a store says how far it is where somebody sits at a terminal, and nowhere else.</summary>
public sealed partial class CellProgressTests : IDisposable
{
    private readonly CellFolder _cell = new();

    public CellProgressTests()
    {
        var settings = CellSettingsReader.Read(_cell.Config);
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var random = new Random(9);
        for (var i = 0; i < 3; i++)
        {
            var bytes = new byte[2 << 20];
            random.NextBytes(bytes);
            store.Archive(new Arrival("cmm", $"S{i}.csv", $"{i}", bytes));
        }

        for (var i = 0; i < 20; i++)
        {
            store.Audit("anna", "looked", "for the test");
        }
    }

    [Fact]
    public void Backup_restore_verify_and_export_say_so_on_a_line_that_goes_away()
    {
        IsTold(["cell", "backup", _cell.Config, _cell["copy.db"]], "copying the store", "looking at each page of the copy ...");
        IsTold(["cell", "restore", _cell.Config, _cell["copy.db"]], "copying the backup", "looking at each page of the copy ...");
        IsTold(["audit", "verify", _cell.Config], "looking at entries");
        IsTold(["audit", "export", _cell.Config, "--out", _cell["audit.csv"]], "writing entries");
    }

    [Fact]
    public void Nothing_is_said_where_nobody_sits()
    {
        foreach (var args in new string[][]
        {
            ["cell", "backup", _cell.Config, _cell["copy.db"]],
            ["audit", "verify", _cell.Config],
            ["cell", "restore", _cell.Config, _cell["copy.db"]]
        })
        {
            var (exit, _, error) = Shell.Run(args);
            Assert.Equal((0, ""), (exit, error));
        }
    }

    [Fact]
    public void Work_that_is_cancelled_leaves_nothing_behind()
    {
        using var cancel = new CancellationTokenSource();
        using var output = new StringWriter();
        using var progress = new CancellingWriter(cancel);
        var terminal = new Terminal(output, TextWriter.Null, HasColor: false) { Progress = progress };
        Assert.Equal(130, Application.Run(["cell", "backup", _cell.Config, _cell["copy.db"]], terminal, cancel.Token));
        Assert.DoesNotContain(
            Directory.EnumerateFiles(Path.GetDirectoryName(_cell.Config)!),
            f => Path.GetFileName(f).StartsWith("copy", StringComparison.Ordinal));

        Assert.Equal(0, Shell.Run("cell", "backup", _cell.Config, _cell["copy.db"]).Exit);
        using var again = new CancellationTokenSource();
        using var another = new CancellingWriter(again);
        Assert.Equal(
            130, Application.Run(["cell", "restore", _cell.Config, _cell["copy.db"]], terminal with { Progress = another }, again.Token));
        Assert.DoesNotContain(
            Directory.EnumerateFiles(Path.GetDirectoryName(_cell.Config)!), f => f.Contains("restore", StringComparison.Ordinal));
        Assert.Equal(0, Shell.Run("audit", "verify", _cell.Config).Exit);
    }

    [Fact]
    public void Who_restores_a_backup_stands_in_the_audit_trail_as_the_operating_system_knows_him()
    {
        Assert.Equal(0, Shell.Run("cell", "backup", _cell.Config, _cell["copy.db"]).Exit);
        Assert.Equal(0, Shell.Run("cell", "restore", _cell.Config, _cell["copy.db"]).Exit);
        var settings = CellSettingsReader.Read(_cell.Config);
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var entry = Assert.Single(store.AuditEntries(0, 10_000), e => e.What == "restored");
        Assert.Equal((SystemUser.Name(Environment.GetEnvironmentVariable), "from the backup copy.db"), (entry.Who, entry.Basis.Sentence));
        Assert.StartsWith("os:" + Environment.UserName, entry.Who, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(null, "")]
    [InlineData("", "")]
    [InlineData("anna", " (sudo by anna)")]
    public void Whom_sudo_lets_be_another_user_is_named_by_both(string? before, string behind) =>
        Assert.Equal($"os:{Environment.UserName}{behind}", SystemUser.Name(name => name == "SUDO_USER" ? before : null));

    [Fact]
    public void Nobody_at_the_cell_has_the_name_of_a_user_of_the_operating_system()
    {
        var run = _cell.Piped([CellFolder.Annas], "user", "add", _cell.Config, "OS:root", "--role", "administrator");
        Assert.Equal(1, run.Exit);
        Assert.Contains("users of the operating system", run.Error, StringComparison.Ordinal);
    }

    public void Dispose() => _cell.Dispose();

    private static void IsTold(string[] args, string doing, string? then = null)
    {
        using var output = new StringWriter { NewLine = "\n" };
        using var error = new StringWriter { NewLine = "\n" };
        using var shown = new StringWriter { NewLine = "\n" };
        var exit = Application.Run(
            args, new Terminal(output, error, HasColor: false) { Progress = shown }, TestContext.Current.CancellationToken);
        Assert.Equal((0, ""), (exit, error.ToString()));
        var lines = shown.ToString().Split('\r', StringSplitOptions.RemoveEmptyEntries);
        var percents = lines.Select(l => Percent().Match(l))
            .Where(m => m.Success && m.Groups["doing"].Value == doing)
            .Select(m => int.Parse(m.Groups["percent"].Value, System.Globalization.CultureInfo.InvariantCulture))
            .ToArray();
        Assert.True(percents.Length > 2, shown.ToString());
        Assert.Equal(percents.Order().Distinct(), percents);
        Assert.InRange(percents[^1], 50, 100);
        if (then is not null)
        {
            Assert.Contains(lines, l => l.Trim() == then);
        }

        // Gone at the end: blanks over what stood there.
        Assert.All(lines[^1], c => Assert.Equal(' ', c));
        Assert.EndsWith("\r", shown.ToString(), StringComparison.Ordinal);
        Assert.DoesNotContain("%", output.ToString(), StringComparison.Ordinal);
    }

    [GeneratedRegex("\\A(?<doing>[a-z ]+): \\[[#.]{20}\\] (?<percent>[0-9]+) %\\s*\\z", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Percent();

    // Cancels as soon as anything is said.
    private sealed class CancellingWriter(CancellationTokenSource cancel) : StringWriter
    {
        public override void Write(string? value) => cancel.Cancel();
    }
}
