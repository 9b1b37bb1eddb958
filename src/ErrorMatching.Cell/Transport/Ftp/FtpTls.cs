namespace ErrorMatching.Cell;

/// <summary>Whether an FTP connection is encrypted.</summary>
public enum FtpTls
{
    /// <summary>Not encrypted: anyone on the network can read and change programs.</summary>
    None,

    /// <summary>Encrypted with <c>AUTH TLS</c> before the login, including data connections.</summary>
    Explicit,

    /// <summary>Encrypted from the first byte.</summary>
    Implicit,
}
