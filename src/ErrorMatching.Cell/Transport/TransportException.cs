namespace ErrorMatching.Cell;

/// <summary>A transfer that failed, or may be partly done.</summary>
/// <param name="error">Why it failed.</param>
/// <param name="message">A sentence for a setter: machine, file, the reply, what to do next. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class TransportException(TransportError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Why it failed.</summary>
    public TransportError Error => error;

    /// <summary>True if the same transfer may well succeed a little later.</summary>
    public bool IsWorthAnotherTry =>
        error is TransportError.Away or TransportError.Slow or TransportError.Differs or TransportError.Unknown;
}
