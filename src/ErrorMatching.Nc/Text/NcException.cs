namespace ErrorMatching.Nc;

/// <summary>A program, selector or dialect that cannot be read at all. One that can be read but not used gives an
/// <see cref="NcRefusal"/>.</summary>
public sealed class NcException : Exception
{
    /// <summary>Creates an error with its reason in words.</summary>
    public NcException(NcErrorCode code, string message)
        : base(message) => Code = code;

    /// <summary>What is wrong.</summary>
    public NcErrorCode Code { get; }
}
