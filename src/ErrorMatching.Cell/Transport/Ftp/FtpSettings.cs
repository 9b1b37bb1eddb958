using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>An FTP server, plain or with TLS. The password is stored as a secret.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Port of the control connection.</param>
/// <param name="User">The login name.</param>
/// <param name="Folder">The program folder, as the server names it.</param>
/// <param name="Tls">Whether the connection is encrypted.</param>
/// <param name="PinnedKey">The server's public key as <c>sha256//</c> and base64, required for every TLS connection; null for plain
/// FTP.</param>
internal sealed record FtpSettings(string Host, int Port, string User, string Folder, FtpTls Tls, string? PinnedKey) : TransportSettings
{
    /// <inheritdoc/>
    public override string Address => string.Create(
        CultureInfo.InvariantCulture, $"{(Tls == FtpTls.None ? "ftp" : "ftps")}://{User}@{Host}:{Port}/{Folder.TrimStart('/')}");

    /// <inheritdoc/>
    public override bool NeedsPassword => true;

    internal override bool IsSamePlace(TransportSettings other) =>
        other is FtpSettings o && ServerFolder.AreSame((Host, Port, Folder), (o.Host, o.Port, o.Folder));

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) =>
        new FtpTransport(machine, this, secret, limit);
}

/// <summary>Whether an FTP connection is encrypted.</summary>
internal enum FtpTls
{
    /// <summary>Not encrypted: anyone on the network can read and change programs.</summary>
    None,

    /// <summary>Encrypted with <c>AUTH TLS</c> before the login, including data connections.</summary>
    Explicit,

    /// <summary>Encrypted from the first byte.</summary>
    Implicit,
}
