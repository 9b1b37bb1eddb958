namespace ErrorMatching.Cell;

/// <summary>A store call failed.</summary>
/// <param name="error">The kind of failure.</param>
/// <param name="message">A sentence for a setter: what could not be done, why, what to do next. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class StoreException(StoreError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>The kind of failure.</summary>
    public StoreError Error => error;

    /// <summary>True if the same call may well succeed a little later without intervention.</summary>
    public bool IsWorthAnotherTry => error is StoreError.Away or StoreError.Locked;
}
