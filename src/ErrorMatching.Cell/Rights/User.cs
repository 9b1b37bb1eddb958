namespace ErrorMatching.Cell;

/// <summary>A person who may sign in.</summary>
/// <param name="Name">The name as given; no other user's name differs from it only in case.</param>
/// <param name="Role">The user's role; the lowest one if <see cref="Problem"/> says that the role is unknown.</param>
/// <param name="IsDisabled">True if the user may not sign in. Users are not deleted: the audit trail names them.</param>
/// <param name="AddedAt">When.</param>
/// <param name="PasswordAt">When the password was last set.</param>
public sealed record User(string Name, Role Role, bool IsDisabled, DateTimeOffset AddedAt, DateTimeOffset PasswordAt)
{
    /// <summary>The role as the store has it.</summary>
    public string RoleWord { get; init; } = Role.ToString().ToLowerInvariant();

    /// <summary>Why the user has no rights, regardless of role: the row was changed outside the cell, or the role is unknown. Null if
    /// neither is the case.</summary>
    public (PeopleError Error, string Message)? Problem { get; init; }

    /// <summary>True if the user has a PIN.</summary>
    public bool HasPin { get; init; }

    /// <summary>True if a badge belongs to the user.</summary>
    public bool HasBadge { get; init; }

    /// <summary>Failed sign-ins since the last successful one.</summary>
    public int Failures { get; init; }

    /// <summary>When the resulting lock ends; null if the name is not locked.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}

/// <summary>Evidence that a user has just given the right password, or what the cell accepts instead. Only a <see cref="UserBook"/> creates
/// it.</summary>
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
