namespace ErrorMatching.Nc;

/// <summary>Something about a program, selector or dialect that cannot be read at all.
/// What can be read but not used is an <see cref="NcRefusal"/>.</summary>
public sealed class NcException : Exception
{
    /// <summary>An error with its reason in words.</summary>
    public NcException(NcErrorCode code, string message)
        : base(message) => Code = code;

    /// <summary>What is wrong.</summary>
    public NcErrorCode Code { get; }
}
