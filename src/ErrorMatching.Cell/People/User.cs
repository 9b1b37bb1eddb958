namespace ErrorMatching.Cell;

/// <summary>Somebody who may sign in.</summary>
/// <param name="Name">The name as it was given; no other user's differs from it in more than large and small letters.</param>
/// <param name="Role">What the user may do; the lowest where <see cref="Problem"/> says that there is no such role.</param>
/// <param name="IsDisabled">True if the user may not sign in. Users are not deleted: the audit trail names them.</param>
/// <param name="AddedAt">When.</param>
/// <param name="PasswordAt">When the password was last set.</param>
public sealed record User(string Name, Role Role, bool IsDisabled, DateTimeOffset AddedAt, DateTimeOffset PasswordAt)
{
    /// <summary>The role as the store has it.</summary>
    public string RoleWord { get; init; } = Role.ToString().ToLowerInvariant();

    /// <summary>Why the user may do nothing, whatever the role says: somebody else wrote to the row, or there is no such role. Null if that
    /// is not so.</summary>
    public (PeopleError Error, string Message)? Problem { get; init; }

    /// <summary>Failed sign-ins since the last one that succeeded.</summary>
    public int Failures { get; init; }

    /// <summary>When the name may be tried again after them; null if it may now.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}
