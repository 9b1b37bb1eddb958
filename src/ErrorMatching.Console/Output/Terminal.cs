using System.Text;

namespace ErrorMatching.Console;

/// <summary>The console's streams: results go to the output, messages to the error stream. In production these are the standard streams, in
/// tests two strings.</summary>
/// <param name="Output">Results.</param>
/// <param name="Error">Messages.</param>
/// <param name="HasColor">True if text for people may contain escape sequences.</param>
internal sealed record Terminal(TextWriter Output, TextWriter Error, bool HasColor)
{
    /// <summary>The source of passwords; by default there is nothing to read.</summary>
    public SecretInput Secrets { get; init; } = new(TextReader.Null, null, Error);

    /// <summary>What <c>-</c> names on the command line; by default there is nothing to read.</summary>
    public StandardInput Input { get; init; } = StandardInput.Empty;

    /// <summary>Opens what <see cref="Output"/> writes to, for programs, which keep their bytes.</summary>
    public Func<Stream> ProgramOutput { get; init; } = () => Stream.Null;

    /// <summary>True if messages may contain escape sequences.</summary>
    public bool HasErrorColor { get; init; }

    /// <summary>The terminal for progress of long operations; null if no person is watching.</summary>
    public TextWriter? Progress { get; init; }

    /// <summary>The standard streams of the process.</summary>
    public static Terminal OfProcess()
    {
        // Neither writer is disposed of: the application flushes, and a second flush of a broken pipe would hide its exit code.
        // The output of a large program is many megabytes, and each full buffer is a call of the system.
        var output = new StreamWriter(System.Console.OpenStandardOutput(), new UTF8Encoding(false), 1 << 14) { NewLine = "\n" };
        var error = new StreamWriter(System.Console.OpenStandardError(), new UTF8Encoding(false)) { NewLine = "\n", AutoFlush = true };
        var (noColor, kind) = (Environment.GetEnvironmentVariable("NO_COLOR"), Environment.GetEnvironmentVariable("TERM"));
        var secrets = new SecretInput(
            new Lazy<TextReader>(() => new StreamReader(System.Console.OpenStandardInput(), new UTF8Encoding(false))),
            System.Console.IsInputRedirected ? null : () => System.Console.ReadKey(intercept: true),
            error);
        return new(output, error, WantsColor(System.Console.IsOutputRedirected, noColor, kind))
        {
            Input = new(System.Console.OpenStandardInput),
            Secrets = secrets,
            ProgramOutput = System.Console.OpenStandardOutput,
            HasErrorColor = WantsColor(System.Console.IsErrorRedirected, noColor, kind),
            Progress = System.Console.IsErrorRedirected || kind == "dumb" ? null : error,
        };
    }

    /// <summary>True if the output is a terminal with color and NO_COLOR is unset or empty (no-color.org).</summary>
    public static bool WantsColor(bool isRedirected, string? noColor, string? terminalKind) =>
        !isRedirected && string.IsNullOrEmpty(noColor) && terminalKind != "dumb";
}
