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

    /// <summary>The same stream as <see cref="Output"/>, for programs, which keep their bytes.</summary>
    public Stream ProgramOutput { get; init; } = Stream.Null;

    /// <summary>True if messages may contain escape sequences.</summary>
    public bool HasErrorColor { get; init; }

    /// <summary>The terminal for progress of long operations; null if no person is watching.</summary>
    public TextWriter? Progress { get; init; }

    /// <summary>True if the output is a terminal with color and NO_COLOR is unset or empty (no-color.org).</summary>
    public static bool WantsColor(bool isRedirected, string? noColor, string? terminalKind) =>
        !isRedirected && string.IsNullOrEmpty(noColor) && terminalKind != "dumb";
}
