namespace ErrorMatching.Cell;

/// <summary>Something that the store could not do.</summary>
/// <param name="error">What it is.</param>
/// <param name="message">A sentence for a setter: what could not be done, why, what to do next. No secrets.</param>
/// <param name="cause">What lies below; null if nothing does.</param>
public sealed class StoreException(StoreError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>What it is.</summary>
    public StoreError Error => error;

    /// <summary>True if the same may well succeed a little later without anybody's doing.</summary>
    public bool IsWorthAnotherTry => error is StoreError.Away or StoreError.Locked;
}
