using System.Diagnostics;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>Programs are run with limits; a shell stands for them here.</summary>
public sealed class ToolProcessTests
{
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(60);

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task Input_output_errors_and_exit_code_come_through()
    {
        var result = await RunAsync("cat; echo bad >&2; exit 3", "G1 X1\r\n\0"u8.ToArray());
        Assert.Equal((ToolEnd.Exited, 3, "bad\n"), (result.End, result.ExitCode, result.Error));
        Assert.Equal("G1 X1\r\n\0"u8.ToArray(), result.Output);
    }

    [Fact]
    public async Task A_program_that_reads_nothing_is_no_failure()
    {
        var result = await RunAsync("exit 0", new byte[1 << 20]);
        Assert.Equal((ToolEnd.Exited, 0), (result.End, result.ExitCode));
    }

    [Fact]
    public async Task Arguments_reach_the_program_as_they_are()
    {
        NeedsShell();
        string[] given = ["a b", "$HOME", "`id`", "\"", "'", "*", ""];
        var result = await ToolProcess.RunAsync(
            new ToolRun("sh", ["-c", "for a; do printf '%s\\n' \"$a\"; done", "sh", .. given], default, Long), Token);
        Assert.Equal(string.Join('\n', given) + "\n", Encoding.UTF8.GetString(result.Output));
    }

    [Fact]
    public async Task Only_what_is_needed_of_the_environment_is_handed_on()
    {
        Environment.SetEnvironmentVariable("ERRORMATCH_TEST_SECRET", "sesame");
        Environment.SetEnvironmentVariable("ftp_proxy", "http://127.0.0.1:1");
        try
        {
            var said = Encoding.UTF8.GetString((await RunAsync("env", default)).Output);
            Assert.DoesNotContain("sesame", said, StringComparison.Ordinal);
            Assert.DoesNotContain("ftp_proxy", said, StringComparison.Ordinal);
            Assert.DoesNotContain("HOME=", said, StringComparison.Ordinal);
            Assert.Contains("LC_ALL=C\n", said, StringComparison.Ordinal);
        }
        finally
        {
            Environment.SetEnvironmentVariable("ERRORMATCH_TEST_SECRET", null);
            Environment.SetEnvironmentVariable("ftp_proxy", null);
        }
    }

    [Fact]
    public async Task After_its_time_a_program_is_killed_with_all_that_it_started()
    {
        NeedsShell();
        var limit = TimeSpan.FromMilliseconds(250);
        ToolResult result;
        do
        {
            // Long enough that it gets to start something, however busy the machine is.
            limit *= 2;
            result = await ToolProcess.RunAsync(new ToolRun("sh", ["-c", "sleep 1000 & echo $!; wait"], default, limit), Token);
            Assert.Equal(ToolEnd.TimedOut, result.End);
        }
        while (result.Output is [] && limit < Long);

        await EndsAsync(int.Parse(Encoding.UTF8.GetString(result.Output), System.Globalization.CultureInfo.InvariantCulture));
    }

    [Fact]
    public async Task A_cancelled_program_is_killed_at_once()
    {
        NeedsShell();
        using var cancel = new CancellationTokenSource();
        var running = ToolProcess.RunAsync(new ToolRun("sh", ["-c", "sleep 1000"], default, Long), cancel.Token);
        await cancel.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => running.WaitAsync(Long, Token));
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => ToolProcess.RunAsync(
            new ToolRun("sh", ["-c", "exit 0"], default, Long), cancel.Token));
    }

    [Fact]
    public async Task A_program_that_says_too_much_is_killed_and_what_is_kept_is_limited()
    {
        NeedsShell();
        var endless = await ToolProcess.RunAsync(
            new ToolRun("sh", ["-c", "while :; do echo 0123456789; done"], default, Long) { MostOutput = 100 }, Token);
        Assert.Equal((ToolEnd.TooMuch, 100), (endless.End, endless.Output.Length));
        var exact = await ToolProcess.RunAsync(new ToolRun("sh", ["-c", "printf 0123456789"], default, Long) { MostOutput = 10 }, Token);
        Assert.Equal((ToolEnd.Exited, 10), (exact.End, exact.Output.Length));
        var complaints = await RunAsync("n=0; while [ $n -lt 4000 ]; do echo 0123456789 >&2; n=$((n + 1)); done", default);
        Assert.Equal((ToolEnd.Exited, 16384), (complaints.End, complaints.Error.Length));
    }

    [Fact]
    public async Task A_program_that_is_not_there_is_named_so()
    {
        var result = await ToolProcess.RunAsync(new ToolRun("errormatch-no-such-program", [], default, Long), Token);
        Assert.Equal(ToolEnd.Missing, result.End);
    }

    private static async Task<ToolResult> RunAsync(string script, byte[]? input)
    {
        NeedsShell();
        return await ToolProcess.RunAsync(new ToolRun("sh", ["-c", script], input, Long), Token);
    }

    private static void NeedsShell() => Assert.SkipWhen(OperatingSystem.IsWindows(), "A shell stands for the programs.");

    // Who is killed may take a moment to go.
    private static async Task EndsAsync(int id)
    {
        var began = Stopwatch.GetTimestamp();
        while (IsAlive(id))
        {
            Assert.True(Stopwatch.GetElapsedTime(began) < Long, $"Process {id} lives on.");
            await Task.Delay(10, Token);
        }
    }

    // A killed process that nobody has buried yet has a state in Linux's list, and is dead.
    private static bool IsAlive(int id)
    {
        try
        {
            using var process = Process.GetProcessById(id);
            return !OperatingSystem.IsLinux() || File.ReadAllText($"/proc/{id}/stat").Split(") ")[^1][0] is not ('Z' or 'X');
        }
        catch (Exception e) when (e is ArgumentException or IOException)
        {
            return false;
        }
    }
}
