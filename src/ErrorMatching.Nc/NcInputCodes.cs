namespace ErrorMatching.Nc;

/// <summary>The stable identifiers of programs, selectors and dialects that cannot be read at all, beside
/// <see cref="NcRefusalCodes.NumberTooLong"/>.</summary>
public static class NcInputCodes
{
    /// <summary>A block selector is not a number, a range or an expression between slashes.</summary>
    public const string BadSelector = "bad-selector";

    /// <summary>No dialect has this name.</summary>
    public const string UnknownDialect = "unknown-dialect";

    /// <summary>The program is larger than the limit.</summary>
    public const string ProgramTooLarge = "program-too-large";

    /// <summary>The program has no block.</summary>
    public const string EmptyProgram = "empty-program";

    /// <summary>The program is in an encoding that no control reads, or is no text.</summary>
    public const string ProgramNotText = "program-not-text";
}
