namespace ErrorMatching.Cell;

/// <summary>Why somebody may not do something, or something about people cannot be done.</summary>
public enum PeopleError
{
    /// <summary>The cell has no users yet.</summary>
    NoUsers,

    /// <summary>Name or password is wrong. Which of the two is not said.</summary>
    SignInRefused,

    /// <summary>Too many failed sign-ins in a row; the name is locked for a while.</summary>
    LockedOut,

    /// <summary>The user is disabled.</summary>
    UserDisabled,

    /// <summary>The store has a role for the user that is none.</summary>
    UnknownRole,

    /// <summary>Somebody else wrote to the user's row in the store.</summary>
    Tampered,

    /// <summary>The user's role does not allow it.</summary>
    NotAllowed,

    /// <summary>The act takes a password of its own, and the one that was given is too long ago or was used for another act.</summary>
    NotSigned,

    /// <summary>A name that no user may have.</summary>
    BadUserName,

    /// <summary>A password that no user may have.</summary>
    WeakPassword,

    /// <summary>There is a user of this name.</summary>
    UserExists,

    /// <summary>There is no user of this name.</summary>
    UnknownUser,

    /// <summary>Nobody would be left to manage users.</summary>
    LastAdministrator,

    /// <summary>A password of a machine that cannot be one: empty, too long, or with line ends or other control characters.</summary>
    BadSecret,

    /// <summary>The keys do not decrypt it: they are those of another installation, or keys or store were changed.</summary>
    SecretUnreadable,

    /// <summary>The folder of the keys cannot be used, or others than its owner can read it.</summary>
    KeysUnusable,

    /// <summary>The store was sealed by a key, and the folder of the keys has none.</summary>
    KeysMissing,
}
