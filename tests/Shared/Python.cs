using System.Diagnostics;

namespace ErrorMatching.Testing;

/// <summary>Scripts of the checkout, run by python3 as a process of their own: the second judge and what attacks it.</summary>
internal static class Python
{
    /// <summary>Skips the current test where python3 is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded()
    {
        var found = (Environment.GetEnvironmentVariable("PATH") ?? "")
            .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
            .Any(f => File.Exists(Path.Combine(f, "python3")));
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(found, "python3 is missing: install the package python3.");
        }

        Assert.SkipUnless(found, "python3 is not installed (package python3).");
    }

    /// <summary>Runs a script of the checkout to its end. It may say nothing on its error stream.</summary>
    /// <param name="folder">The folder to run it in.</param>
    /// <param name="script">Its path in the checkout.</param>
    /// <param name="arguments">Its arguments.</param>
    public static (int Exit, string Output) Run(string folder, string script, params IEnumerable<string> arguments)
    {
        var start = new ProcessStartInfo("python3", [Repository.PathTo(script), .. arguments])
        {
            WorkingDirectory = folder,
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using var process = Process.Start(start)!;
        var error = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.Equal("", error.GetAwaiter().GetResult());
        return (process.ExitCode, output);
    }
}
