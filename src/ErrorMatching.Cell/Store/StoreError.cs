namespace ErrorMatching.Cell;

/// <summary>What the store could not do. Whatever it is, nothing of the call was kept, except where <see cref="Away"/> says otherwise.</summary>
public enum StoreError
{
    /// <summary>Somebody else changed it since it was read, or what is asked is no longer a step that leads from where it is.</summary>
    Conflict,

    /// <summary>What is named is not in the store, or the store is not where it is looked for.</summary>
    Missing,

    /// <summary>What was read is not what was written: a page, a file or a content is damaged.</summary>
    Damaged,

    /// <summary>Somebody else wrote to it: a row, the audit trail or the form of the database is not what the cell left.</summary>
    Tampered,

    /// <summary>The database is another program's.</summary>
    Foreign,

    /// <summary>A newer version of the program made it.</summary>
    TooNew,

    /// <summary>Another process held it for longer than one waits.</summary>
    Locked,

    /// <summary>The disk has no room.</summary>
    Full,

    /// <summary>The disk or the file cannot be written.</summary>
    ReadOnly,

    /// <summary>The operating system or the server does not let this user in.</summary>
    Denied,

    /// <summary>The disk reported an error.</summary>
    Disk,

    /// <summary>Another file took the store's place while it was open, and lacks what was kept.</summary>
    Replaced,

    /// <summary>The server does not answer, or the connection broke. If it broke while a change was being kept, read again whether it was.</summary>
    Away,

    /// <summary>This kind of store does not do it.</summary>
    NotSupported,

    /// <summary>An answer of the database that says nothing known.</summary>
    Unknown,
}
