namespace ErrorMatching.Nc;

/// <summary>Why a program, selector or dialect cannot be read.</summary>
public enum NcErrorCode
{
    /// <summary>A number has more digits than are represented exactly.</summary>
    NumberTooLong,

    /// <summary>A block selector is not a number, a range or an expression between slashes.</summary>
    BadSelector,

    /// <summary>No dialect has this name.</summary>
    UnknownDialect,

    /// <summary>The program is larger than the limit.</summary>
    ProgramTooLarge,
}
