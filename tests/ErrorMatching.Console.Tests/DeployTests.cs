using System.Diagnostics;
using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What is installed with a cell, and the pages about it, say what this console understands.</summary>
public sealed partial class DeployTests
{
    private static readonly string[] Pages = [
        "install-a-cell.md", "cell-at-night.md", "keep-the-store.md", "users-and-rights.md", "connect-a-machine.md", "configure-a-cell.md"];
    private static readonly string Unit = File.ReadAllText(Repository.PathTo("deploy", "errormatch-cell.service"));
    private static readonly string Script = File.ReadAllText(Repository.PathTo("deploy", "windows-service.ps1"));
    private static readonly string Installing = Page("install-a-cell.md");

    [Fact]
    public void The_unit_starts_what_the_console_understands()
    {
        var words = Value("ExecStart").Split(' ');
        Assert.Equal("/opt/errormatch/errormatch", words[0]);
        IsUnderstood(words[1..]);
        Assert.IsType<CellRun>(CommandTree.Parse(words[1..]).CommandResult.Command);
    }

    [Fact]
    public void The_unit_and_the_page_about_it_name_the_same_places()
    {
        Assert.Contains(
            $"-o {Path.GetDirectoryName(Value("ExecStart").Split(' ')[0])!.Replace('\\', '/')}`", Installing, StringComparison.Ordinal);
        Assert.Contains($"cell.json {Value("ExecStart").Split(' ')[^1]}\n", Installing, StringComparison.Ordinal);
        Assert.Contains(
            $"useradd --system --home /var/lib/{Value("StateDirectory")} --shell /usr/sbin/nologin {Value("User")}\n",
            Installing,
            StringComparison.Ordinal);
        Assert.Contains($"\"file\": \"/var/lib/{Value("StateDirectory")}/", Installing, StringComparison.Ordinal);
        Assert.Contains($"\"logs\": \"/var/log/{Value("LogsDirectory")}\"", Installing, StringComparison.Ordinal);
        Assert.Contains($"\"incoming\": \"{Value("ReadWritePaths").TrimStart('-')}/", Installing, StringComparison.Ordinal);
        Assert.Contains(Value("EnvironmentFile").TrimStart('-'), Installing, StringComparison.Ordinal);
        Assert.True(File.Exists(Repository.PathTo("docs", Path.GetFileName(Value("Documentation")))));
    }

    [Fact]
    public void The_unit_waits_as_long_as_the_cell_may_take()
    {
        // The cell ends within 10 s, and says every 2 s that it lives.
        Assert.InRange(Seconds("TimeoutStopSec"), 11, 60);
        Assert.InRange(Seconds("WatchdogSec"), 10, 300);
        Assert.Equal(("notify", "SIGTERM", "always"), (Value("Type"), Value("KillSignal"), Value("Restart")));
        Assert.Contains(((int)ExitCode.Cancelled).ToString(CultureInfo.InvariantCulture), Value("SuccessExitStatus").Split(' '));

        double Seconds(string name) => double.Parse(Value(name), CultureInfo.InvariantCulture);
    }

    [Fact]
    public void What_a_person_must_look_at_is_not_started_again_for_ever()
    {
        using var folder = new TemporaryFolder();
        var wrong = folder.File("cell.json", "{ \"kind\": \"cell\" }");
        Assert.Equal((int)ExitCode.WrongInput, Shell.Run("cell", "run", wrong).Exit);
        var prevented = Value("RestartPreventExitStatus").Split(' ').Select(n => (ExitCode)int.Parse(n, CultureInfo.InvariantCulture));
        Assert.Equal([ExitCode.WrongInput, ExitCode.Refused], prevented);
    }

    [Fact]
    public void A_machines_key_is_made_by_the_account_that_reads_it()
    {
        var page = Page("connect-a-machine.md");
        var made = Assert.Single(page.Split('\n'), l => l.Contains("ssh-keygen -t", StringComparison.Ordinal)).Trim();
        Assert.StartsWith($"sudo -u {Value("User")} ", made, StringComparison.Ordinal);
        var file = made.Split(' ')[^1];
        Assert.StartsWith($"/var/lib/{Value("StateDirectory")}/", file, StringComparison.Ordinal);
        Assert.Contains($"\"keyFile\": \"{file}\"", page, StringComparison.Ordinal);
    }

    // README.md: measures a part, rewrites the program of its counterpart.
    [Fact]
    public void The_package_says_which_piece_is_measured_and_which_program_follows()
    {
        var text = File.ReadAllText(Repository.PathTo("deploy", "debian", "errormatch.control"));
        Assert.Contains("Description: NC programs that follow the measured part\n", text, StringComparison.Ordinal);
        Assert.Contains("Measures a machined part, rewrites the NC program of its counterpart", text, StringComparison.Ordinal);
        Assert.DoesNotContain("measured counterpart", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("ProtectSystem", "strict")]
    [InlineData("NoNewPrivileges", "true")]
    [InlineData("PrivateTmp", "true")]
    [InlineData("ProtectHome", "true")]
    [InlineData("CapabilityBoundingSet", "")]
    [InlineData("MemorySwapMax", "0")]
    [InlineData("LimitCORE", "0")]
    public void The_unit_gives_the_cell_no_more_than_it_needs(string name, string value) => Assert.Equal(value, Value(name));

    [Fact]
    public void The_unit_lets_the_cell_do_its_work()
    {
        // sd_notify and a database's socket, machines and broker, over either protocol of the Internet.
        Assert.Equal(["AF_UNIX", "AF_INET", "AF_INET6"], Value("RestrictAddressFamilies").Split(' '));
        Assert.True(Gigabytes("MemoryHigh") < Gigabytes("MemoryMax"));
        Assert.True(int.Parse(Value("TasksMax"), CultureInfo.InvariantCulture) >= 256);

        // The runtime compiles code while it runs; curl and sftp are programs; their answers come over the network.
        Assert.All(
            Unit.Split('\n').Where(l => !l.StartsWith('#')),
            l => Assert.DoesNotMatch("^(MemoryDenyWriteExecute|PrivateNetwork|NoExecPaths|ProcSubset|IPAddressDeny|RootDirectory)=", l));

        double Gigabytes(string name) => double.Parse(Value(name).TrimEnd('G'), CultureInfo.InvariantCulture);
    }

    [Fact]
    public void Systemd_understands_the_unit_and_finds_it_hardened()
    {
        Assert.SkipUnless(
            OperatingSystem.IsLinux() && File.Exists("/usr/bin/systemd-analyze"), "systemd-analyze is not installed (package systemd).");
        using var folder = new TemporaryFolder();

        // verify looks whether the program is there.
        var unit = folder.File(
            "errormatch-cell.service", Unit.Replace("/opt/errormatch/errormatch ", "/bin/sh ", StringComparison.Ordinal));
        var (exit, said) = Run("systemd-analyze", "verify", "--man=no", unit);
        Assert.True(exit == 0 && !said.Contains("errormatch-cell.service", StringComparison.Ordinal), said);

        // In tenths: 2.0 of 10 and below is what systemd calls well protected.
        (exit, said) = Run("systemd-analyze", "security", "--offline=true", "--threshold=15", "--no-pager", unit);
        Assert.True(exit == 0, said);
        Assert.Contains("Overall exposure level for errormatch-cell.service", said, StringComparison.Ordinal);
    }

    [Fact]
    public void People_may_decide_by_the_cells_account_and_do_nothing_else_with_it()
    {
        var rules = File.ReadAllText(Repository.PathTo("deploy", "errormatch.sudoers"));
        var rule = Assert.Single(rules.Split('\n'), l => l.StartsWith("Cmnd_Alias", StringComparison.Ordinal)).Split(" = ")[1];
        Assert.StartsWith(Value("ExecStart").Split(' ')[0] + " ^", rule, StringComparison.Ordinal);
        var allowed = new Regex(rule[(rule.IndexOf(' ', StringComparison.Ordinal) + 1)..], RegexOptions.None, TimeSpan.FromSeconds(1));
        string[] decisions = ["approve", "release", "reject", "again", "revert"];
        foreach (var decision in decisions)
        {
            var words = $"cell {decision} {Value("ExecStart").Split(' ')[^1]} 17 --user ben --reason chatter";
            Assert.Matches(allowed, words);
            IsUnderstood(words.Split(' '));
        }

        // Verbs that write files or change people, another cell, a file for a number.
        Assert.All(
            CommandTree.Build("cell").Subcommands[0].Subcommands.Select(c => c.Name).Except(decisions, StringComparer.Ordinal),
            verb => Assert.DoesNotMatch(allowed, $"cell {verb} /etc/errormatch/cell.json 17 --user ben"));
        Assert.All(
            new[]
            {
                "audit export /etc/errormatch/cell.json", "user add /etc/errormatch/cell.json eve --user ben",
                "cell approve /etc/ben/cell.json 17 --user ben", "cell approve /etc/errormatch/cell_json 17 --user ben",
                "cell approve /etc/errormatch/cell.json 17", "cell approve /etc/errormatch/cell.json @file --user ben",
            },
            words => Assert.DoesNotMatch(allowed, words));
        Assert.Contains("env_reset, !setenv", rules, StringComparison.Ordinal);
        if (OperatingSystem.IsLinux() && File.Exists("/usr/sbin/visudo"))
        {
            var (exit, said) = Run("/usr/sbin/visudo", "-cf", Repository.PathTo("deploy", "errormatch.sudoers"));
            Assert.True(exit == 0, said);
        }
    }

    [Fact]
    public void The_service_of_Windows_runs_what_the_console_understands_and_takes_what_its_pages_give()
    {
        var commands = Called().Matches(Script)
            .Select(m => m.Groups["words"].Value)
            .Append(Argument().Match(Script).Groups["words"].Value.Replace("`\"", "", StringComparison.Ordinal))
            .ToArray();
        Assert.Equal(["cell check $Config", "cell status $Config", "cell run $Config"], commands);
        Assert.All(commands, c => IsUnderstood(c.Replace("$Config", "cell.json", StringComparison.Ordinal).Split(' ')));
        var parameters = Parameter().Matches(Script).Select(m => m.Groups["name"].Value).ToArray();
        Assert.Equal(["Program", "Config", "Name", "Account"], parameters);
        foreach (var text in new[] { Script, Installing })
        {
            var call = text.Split('\n').Single(l => l.Contains("windows-service.ps1 -", StringComparison.Ordinal));
            Assert.Equal(["Program", "Config"], Given().Matches(call).Select(m => m.Groups["name"].Value));
        }

        Assert.Contains(
            $"Start-Service {ServiceName().Match(Script).Groups["name"].Value}`", Page("cell-at-night.md"), StringComparison.Ordinal);
    }

    [Fact]
    public void Every_command_of_the_pages_about_a_cell_is_understood()
    {
        var seen = 0;
        foreach (var page in Pages)
        {
            foreach (Match match in Command().Matches(Page(page)))
            {
                // A whole one: a verb alone is only spoken of.
                var line = match.Groups["line"].Value.Split('#', '>')[0].Trim();
                var words = Word().Matches(line).Select(m => m.Value.Trim('"')).Select(w => w == "NUMBER" ? "1" : w).ToArray();
                if (words.Length > 2)
                {
                    IsUnderstood(words, page);
                    seen++;
                }
            }
        }

        Assert.InRange(seen, 25, 200);
    }

    [Fact]
    public void The_words_of_states_are_those_of_the_cell() =>
        Assert.Equal(Enum.GetValues<CorrectionState>().Select(CorrectionJson.Word), CellHistory.States);

    private static string Page(string name) => File.ReadAllText(Repository.PathTo("docs", name));

    private static string Value(string name) =>
        Assert.Single(Unit.Split('\n'), l => l.StartsWith(name + "=", StringComparison.Ordinal))[(name.Length + 1)..].Trim();

    private static void IsUnderstood(string[] words, string where = "deploy")
    {
        var parsed = CommandTree.Parse(words);
        Assert.True(
            parsed.Errors.Count == 0 && parsed.CommandResult.Command is Verb,
            $"{where}: {string.Join(' ', words)}: {string.Join(' ', parsed.Errors.Select(e => e.Message))}");
    }

    private static (int Exit, string Said) Run(string program, params string[] words)
    {
        using var process = Process.Start(
            new ProcessStartInfo(program, words) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true })!;
        var error = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output + error.GetAwaiter().GetResult());
    }

    [GeneratedRegex("^& \\$Program (?<words>[^\\r\\n]+)", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Called();

    [GeneratedRegex("-BinaryPathName \"`\"\\$Program`\" (?<words>[^\"]+\"[^\"]+\")\"", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Argument();

    [GeneratedRegex("\\[string\\] \\$(?<name>[A-Za-z]+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Parameter();

    [GeneratedRegex(" -(?<name>[A-Z][a-z]+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Given();

    [GeneratedRegex("\\$Name = '(?<name>[^']+)'", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ServiceName();

    [GeneratedRegex("(`|^|/|\\$ )errormatch (?<line>[a-z][^`\\r\\n]*)", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Command();

    [GeneratedRegex("\"[^\"]*\"|[^ ]+", RegexOptions.None, 1000)]
    private static partial Regex Word();
}
