namespace ErrorMatching.Cell;

/// <summary>Something that a person may not do, or that cannot be done about people and secrets.</summary>
/// <param name="error">Why not.</param>
/// <param name="message">A sentence for the one who asked: what was found and what to do. No secrets.</param>
/// <param name="cause">What lies below; null if nothing does.</param>
public sealed class PeopleException(PeopleError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Why not.</summary>
    public PeopleError Error => error;

    /// <summary>When the name may be tried again; null unless it is locked.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}
