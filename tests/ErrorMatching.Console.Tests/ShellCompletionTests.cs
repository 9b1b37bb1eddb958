using System.Diagnostics;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Shells complete what a person types with the scripts that the console prints.</summary>
public sealed class ShellCompletionTests
{
    // A person presses Tab on a terminal of its own (zpty).
    private const string Session = """
        zmodload zsh/zpty
        path=($1 $path)
        zpty shell zsh -f -i
        zpty -w shell "PS1=; ZDOTDIR=$2; fpath=($2 \$fpath); autoload -Uz compinit; compinit -u -D; $3; print REA''DY"
        zpty -r shell shown '*READY*'
        zpty -w -n shell $'errormatch nc disp\t --norm\t'
        zpty -r shell shown '*--normal*'
        print -r -- $shown
        zpty -d shell
        """;

    [Theory]
    [InlineData(":")]
    [InlineData("source $2/_errormatch")]
    public async Task Tab_completes_verbs_and_options_in_zsh(string start)
    {
        Assert.SkipUnless(File.Exists("/usr/bin/zsh"), "zsh is not installed (package zsh).");
        using var folder = new TemporaryFolder();
        folder.File("_errormatch", CompletionScript.Of("zsh"));
        var session = folder.File("session.zsh", Session.Replace("$3", start, StringComparison.Ordinal));
        var shown = await Shown("/usr/bin/zsh", "-f", session, AppContext.BaseDirectory, folder.Path);
        Assert.Contains("displace", shown, StringComparison.Ordinal);
        Assert.Contains("--normal", shown, StringComparison.Ordinal);
    }

    [Fact]
    public async Task PowerShell_completes_verbs_and_options()
    {
        var shell = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator)
            .Select(f => Path.Combine(f, "pwsh"))
            .FirstOrDefault(File.Exists);
        Assert.SkipWhen(shell is null, "pwsh is not installed (dotnet tool install --global PowerShell).");
        var shown = await Shown(
            shell,
            "-NoProfile",
            "-NonInteractive",
            "-Command",
            $"$env:PATH = '{AppContext.BaseDirectory}' + [IO.Path]::PathSeparator + $env:PATH; "
                + "errormatch completion pwsh | Out-String | Invoke-Expression; "
                + "(TabExpansion2 'errormatch nc disp' 18).CompletionMatches.CompletionText; "
                + "(TabExpansion2 'errormatch nc displace x --no' 29).CompletionMatches.CompletionText");
        Assert.Equal(["displace", "--normal"], shown.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries));
    }

    private static async Task<string> Shown(string program, params string[] words)
    {
        using var shell = Process.Start(
            new ProcessStartInfo(program, words) { UseShellExecute = false, RedirectStandardOutput = true })!;
        using var patience = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        patience.CancelAfter(TimeSpan.FromSeconds(60));
        try
        {
            return await shell.StandardOutput.ReadToEndAsync(patience.Token);
        }
        catch (OperationCanceledException e) when (!TestContext.Current.CancellationToken.IsCancellationRequested)
        {
            throw new TimeoutException($"{program} completed nothing within a minute.", e);
        }
        finally
        {
            shell.Kill(entireProcessTree: true);
        }
    }
}
