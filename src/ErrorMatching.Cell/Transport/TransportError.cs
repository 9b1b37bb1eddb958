namespace ErrorMatching.Cell;

/// <summary>What kept a transfer from happening.</summary>
public enum TransportError
{
    /// <summary>The machine does not answer, or the connection broke. Worth another try.</summary>
    Away,

    /// <summary>The machine took too long. Worth another try.</summary>
    Slow,

    /// <summary>The login was refused.</summary>
    Login,

    /// <summary>The server is not the one whose key is pinned.</summary>
    WrongServer,

    /// <summary>The server does not allow it, or not under this name (FTP 550, 553).</summary>
    Denied,

    /// <summary>The server has no room (FTP 552, 452).</summary>
    Full,

    /// <summary>The server does not rename over an existing file.</summary>
    CannotReplace,

    /// <summary>What was read back is not what was written.</summary>
    Differs,

    /// <summary>The file at the machine is larger than what is read.</summary>
    TooLarge,

    /// <summary>Something has the file's name and is none: a link, a pipe, a device or a folder.</summary>
    NotAFile,

    /// <summary>A program that this machine lacks: <c>curl</c> or <c>sftp</c>.</summary>
    ToolMissing,

    /// <summary>An answer that says nothing known.</summary>
    Unknown,
}
