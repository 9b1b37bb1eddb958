namespace ErrorMatching.Cell;

/// <summary>A person may not do something, or an operation on users or secrets failed.</summary>
/// <param name="error">The reason.</param>
/// <param name="message">A sentence for the caller: the problem and what to do. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class PeopleException(PeopleError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>The reason.</summary>
    public PeopleError Error => error;

    /// <summary>When the lock on the name ends; null unless it is locked.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}
