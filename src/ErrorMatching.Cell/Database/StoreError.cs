using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Why a store call failed. Nothing of the call was stored, except as noted under <see cref="Away"/>.</summary>
public enum StoreError
{
    /// <summary>Someone else changed it since it was read, or the requested step is no longer allowed from its current state.</summary>
    Conflict,

    /// <summary>The named item is not in the store, or the store is not where it is expected.</summary>
    Missing,

    /// <summary>What was read differs from what was written: a page, a file or content is damaged.</summary>
    Damaged,

    /// <summary>It was changed outside the cell: a row, the audit trail or the schema is not what the cell left.</summary>
    Tampered,

    /// <summary>The database belongs to another program.</summary>
    Foreign,

    /// <summary>A newer version of the program created it.</summary>
    TooNew,

    /// <summary>Another process held it longer than the wait limit.</summary>
    Locked,

    /// <summary>The disk is full.</summary>
    Full,

    /// <summary>The disk or the file cannot be written.</summary>
    ReadOnly,

    /// <summary>The operating system or the server denies this user access.</summary>
    Denied,

    /// <summary>The disk reported an error.</summary>
    Disk,

    /// <summary>Another file replaced the store while it was open, and lacks data that was stored.</summary>
    Replaced,

    /// <summary>The server does not respond, or the connection broke. If it broke during a change, read again to find out whether the
    /// change was stored.</summary>
    Away,

    /// <summary>A page is drawn from its stored report, and this version of the program draws it differently from the one that
    /// recorded it.</summary>
    Redrawn,

    /// <summary>A content was moved to an archive, and the archive is not in its folder.</summary>
    Archived,

    /// <summary>This kind of store does not support it.</summary>
    NotSupported,

    /// <summary>The database returned an unexpected error.</summary>
    Unknown,
}

/// <summary>A store call failed.</summary>
/// <param name="error">The kind of failure.</param>
/// <param name="message">A sentence for a setter: what could not be done, why, what to do next. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class StoreException(StoreError error, Statement message, Exception? cause = null) : Exception(message?.Sentence, cause)
{
    /// <summary>The kind of failure.</summary>
    public StoreError Error => error;

    /// <summary>The message as it is recorded.</summary>
    public Statement Statement => message;

    /// <summary>True if the same call may well succeed a little later without intervention.</summary>
    public bool IsWorthAnotherTry => error is StoreError.Away or StoreError.Locked;
}
