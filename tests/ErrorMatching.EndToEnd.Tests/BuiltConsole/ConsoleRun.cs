using System.Diagnostics;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>One run of the built console as a process.</summary>
internal sealed record ConsoleRun(int Exit, string Output, string Error)
{
    private static readonly UTF8Encoding Strict = new(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);

    private const string Name = "errormatch";

    /// <summary>The executable: what ERRORMATCH_CONSOLE names, the native one or a script that starts the console for another system, or
    /// else the one that is built in the same configuration as these tests.</summary>
    public static string Executable { get; } = Other ?? Built;

    /// <summary>The console that is built in the same configuration as these tests, in libraries.</summary>
    public static string Built
    {
        get
        {
            // Tests and console are built side by side: .../bin/<project>/<configuration>/
            var configuration = new DirectoryInfo(AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar));
            return Path.Combine(
                configuration.Parent!.Parent!.FullName,
                "ErrorMatching.Console",
                configuration.Name,
                OperatingSystem.IsWindows() ? Name + ".exe" : Name);
        }
    }

    /// <summary>True if a signal asks the console to end; false for one of Windows.</summary>
    public static bool HasSignals => !OperatingSystem.IsWindows() && (Other is null || Path.GetFileName(Other) == Name);

    private static string? Other => Environment.GetEnvironmentVariable("ERRORMATCH_CONSOLE");

    /// <summary>The one JSON document of the run.</summary>
    public JsonElement Json
    {
        get
        {
            using var document = JsonDocument.Parse(Output);
            return document.RootElement.Clone();
        }
    }

    /// <summary>The only error of a document of errors.</summary>
    public JsonElement SingleError => Assert.Single(Json.GetProperty("errors").EnumerateArray());

    /// <summary>Runs a command line in a folder.</summary>
    public static Task<ConsoleRun> Of(string folder, params IReadOnlyList<string> arguments) =>
        Of(folder, new Dictionary<string, string?>(), arguments);

    /// <summary>Runs a command line in a folder with other variables in its environment.</summary>
    public static Task<ConsoleRun> Of(string folder, IReadOnlyDictionary<string, string?> environment, IReadOnlyList<string> arguments) =>
        Of(folder, environment, arguments, "");

    /// <summary>Runs a command line in a folder with lines on its standard input.</summary>
    public static Task<ConsoleRun> Typed(string folder, IReadOnlyList<string> arguments, params IReadOnlyList<string> lines) =>
        Of(folder, new Dictionary<string, string?>(), arguments, string.Concat(lines.Select(l => l + "\n")));

    private static async Task<ConsoleRun> Of(
        string folder, IReadOnlyDictionary<string, string?> environment, IReadOnlyList<string> arguments, string input)
    {
        var start = new ProcessStartInfo(Executable, arguments) { WorkingDirectory = folder };
        foreach (var (name, value) in environment)
        {
            start.Environment[name] = value;
        }

        return await Of(start, input);
    }

    /// <summary>Runs a command line that is started in another way, with its standard input.</summary>
    public static async Task<ConsoleRun> Of(ProcessStartInfo start, string input = "")
    {
        start.UseShellExecute = false;
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        start.StandardInputEncoding = start.StandardOutputEncoding = start.StandardErrorEncoding = Strict;
        using var process = Process.Start(start)!;
        var token = TestContext.Current.CancellationToken;
        await process.StandardInput.WriteAsync(input);
        process.StandardInput.Close();
        var (output, error) = (process.StandardOutput.ReadToEndAsync(token), process.StandardError.ReadToEndAsync(token));
        await process.WaitForExitAsync(token);
        return new(process.ExitCode, await output, await error);
    }
}
