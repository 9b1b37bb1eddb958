namespace ErrorMatching.Cell;

/// <summary>A transfer that did not happen, or may have happened in part.</summary>
/// <param name="error">What kept it from happening.</param>
/// <param name="message">A sentence for a setter: machine, file, what was answered, what to do next. No secrets.</param>
/// <param name="cause">What lies below; null if nothing does.</param>
public sealed class TransportException(TransportError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>What kept it from happening.</summary>
    public TransportError Error => error;

    /// <summary>True if the same may well succeed a little later.</summary>
    public bool IsWorthAnotherTry => error is TransportError.Away or TransportError.Slow or TransportError.Differs or TransportError.Unknown;
}
