namespace ErrorMatching.Cell;

/// <summary>Whether an FTP connection is encrypted.</summary>
public enum FtpTls
{
    /// <summary>It is not: anybody on the network can read and change programs.</summary>
    None,

    /// <summary>It becomes so by <c>AUTH TLS</c> before the login, data connections too.</summary>
    Explicit,

    /// <summary>It is from the first byte.</summary>
    Implicit,
}
