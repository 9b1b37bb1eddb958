namespace ErrorMatching.Console;

/// <summary>Where the console writes: results to the output, messages to the error stream. In production the two standard streams, in tests two strings.</summary>
/// <param name="Output">Results.</param>
/// <param name="Error">Messages.</param>
/// <param name="HasColor">True if text for people may carry escape sequences.</param>
internal sealed record Terminal(TextWriter Output, TextWriter Error, bool HasColor)
{
    /// <summary>Where passwords come from. Without one, nothing is there to be read.</summary>
    public SecretInput Secrets { get; init; } = new(TextReader.Null, null, Error);

    /// <summary>Where long work says how far it is: a terminal in front of which somebody sits. Null where nobody does.</summary>
    public TextWriter? Progress { get; init; }

    /// <summary>True if the output is a terminal that shows color and nobody asked for none (no-color.org: any value of NO_COLOR but an empty one).</summary>
    public static bool WantsColor(bool isRedirected, string? noColor, string? terminalKind) => !isRedirected && string.IsNullOrEmpty(noColor) && terminalKind != "dumb";
}
