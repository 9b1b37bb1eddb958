using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Why a user may not do something, or why an operation on users or secrets failed.</summary>
public enum PeopleError
{
    /// <summary>The cell has no users yet.</summary>
    NoUsers,

    /// <summary>Name or password is wrong. The error does not tell which.</summary>
    SignInRefused,

    /// <summary>Too many consecutive failed sign-ins; the name is locked for a while.</summary>
    LockedOut,

    /// <summary>The user is disabled.</summary>
    UserDisabled,

    /// <summary>The store has an unknown role for the user.</summary>
    UnknownRole,

    /// <summary>The user's row in the store was changed outside the cell.</summary>
    Tampered,

    /// <summary>The user's role does not allow it.</summary>
    NotAllowed,

    /// <summary>The act requires its own password entry, and the given one is too old or was used for another act.</summary>
    NotSigned,

    /// <summary>The user name is not allowed.</summary>
    BadUserName,

    /// <summary>The password is not allowed.</summary>
    WeakPassword,

    /// <summary>The PIN is not allowed.</summary>
    WeakPin,

    /// <summary>The badge's code is not allowed.</summary>
    BadBadge,

    /// <summary>The badge belongs to another user.</summary>
    BadgeTaken,

    /// <summary>The cell does not let people sign in this way, or the user has nothing to do so with.</summary>
    WayNotAllowed,

    /// <summary>A user with this name exists.</summary>
    UserExists,

    /// <summary>No user with this name exists.</summary>
    UnknownUser,

    /// <summary>No one would be left to manage users.</summary>
    LastAdministrator,

    /// <summary>The machine password is invalid: empty, too long, or with line ends or other control characters.</summary>
    BadSecret,

    /// <summary>The keys cannot decrypt it: they belong to another installation, or keys or store were changed.</summary>
    SecretUnreadable,

    /// <summary>The key folder cannot be used, or users other than its owner can read it.</summary>
    KeysUnusable,

    /// <summary>The store was sealed with a key that is missing from the key folder.</summary>
    KeysMissing,
}

/// <summary>A person may not do something, or an operation on users or secrets failed.</summary>
/// <param name="error">The reason.</param>
/// <param name="message">A sentence for the caller: the problem and what to do. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class PeopleException(PeopleError error, Statement message, Exception? cause = null) : Exception(message?.Sentence, cause)
{
    /// <summary>The reason.</summary>
    public PeopleError Error => error;

    /// <summary>The message as it is recorded.</summary>
    public Statement Statement => message;

    /// <summary>When the lock on the name ends; null unless it is locked.</summary>
    public DateTimeOffset? LockedUntil { get; init; }
}
