namespace ErrorMatching.Nc;

/// <summary>Why a program, a selector or a dialect cannot be read.</summary>
public enum NcErrorCode
{
    /// <summary>A number has more digits than are represented exactly.</summary>
    NumberTooLong,

    /// <summary>A block selector is neither a number, a range nor an expression between slashes.</summary>
    BadSelector,

    /// <summary>No dialect of this name is known.</summary>
    UnknownDialect,

    /// <summary>The program is larger than the limit.</summary>
    ProgramTooLarge,
}
