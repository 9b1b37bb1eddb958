namespace ErrorMatching.Cell;

/// <summary>Somebody who may sign in.</summary>
/// <param name="Name">The name as it was given; no other user's differs from it in more than large and small letters.</param>
/// <param name="Role">What the user may do.</param>
/// <param name="IsDisabled">True if the user may not sign in. Users are not deleted: the audit trail names them.</param>
/// <param name="AddedAt">When.</param>
/// <param name="PasswordAt">When the password was last set.</param>
public sealed record User(string Name, Role Role, bool IsDisabled, DateTimeOffset AddedAt, DateTimeOffset PasswordAt)
{
    /// <summary>Failed sign-ins since the last one that succeeded.</summary>
    public int Failures { get; init; }

    /// <summary>When the name may be tried again after them; null if it may now.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}
