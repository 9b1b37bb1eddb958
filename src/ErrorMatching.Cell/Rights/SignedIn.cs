namespace ErrorMatching.Cell;

/// <summary>Evidence that a user has just given the right password. Only <see cref="UserBook.SignIn"/> creates it.</summary>
public sealed class SignedIn
{
    private readonly long _timestamp;
    private int _uses;

    internal SignedIn(User user, TimeProvider clock)
    {
        (Name, Role, At) = (user.Name, user.Role, clock.GetUtcNow());
        _timestamp = clock.GetTimestamp();
    }

    /// <summary>The user's name.</summary>
    public string Name { get; }

    /// <summary>The user's role at that time.</summary>
    public Role Role { get; }

    /// <summary>When the password was given.</summary>
    public DateTimeOffset At { get; }

    /// <summary>True once, and only within the given time after the password was given: for acts that require their own password
    /// entry.</summary>
    internal bool Sign(TimeProvider clock, TimeSpan within) =>
        clock.GetElapsedTime(_timestamp) <= within && Interlocked.Increment(ref _uses) == 1;
}
