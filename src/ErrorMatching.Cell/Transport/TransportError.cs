namespace ErrorMatching.Cell;

/// <summary>Why a transfer failed.</summary>
public enum TransportError
{
    /// <summary>The machine does not respond, or the connection broke. Worth a retry.</summary>
    Away,

    /// <summary>The machine took too long. Worth a retry.</summary>
    Slow,

    /// <summary>The login was refused.</summary>
    Login,

    /// <summary>The server's key is not the pinned one.</summary>
    WrongServer,

    /// <summary>The server denies it, or denies this name (FTP 550, 553).</summary>
    Denied,

    /// <summary>The server's disk is full (FTP 552, 452).</summary>
    Full,

    /// <summary>The server does not rename over an existing file.</summary>
    CannotReplace,

    /// <summary>The bytes read back differ from those written.</summary>
    Differs,

    /// <summary>The file at the machine exceeds the size limit.</summary>
    TooLarge,

    /// <summary>The file's name belongs to something else: a link, a pipe, a device or a folder.</summary>
    NotAFile,

    /// <summary>This computer lacks the program <c>curl</c>.</summary>
    ToolMissing,

    /// <summary>An unexpected error.</summary>
    Unknown,
}
