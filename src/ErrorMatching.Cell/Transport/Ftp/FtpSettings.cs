using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>An FTP server, plain or with TLS. The password is a secret of the store.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Port of the control connection.</param>
/// <param name="User">The login's name.</param>
/// <param name="Folder">The programs' folder, as the server names it.</param>
/// <param name="Tls">Whether the connection is encrypted.</param>
/// <param name="PinnedKey">The server's public key as <c>sha256//</c> and base 64, without which no TLS connection is trusted; null for plain FTP.</param>
public sealed record FtpSettings(string Host, int Port, string User, string Folder, FtpTls Tls, string? PinnedKey) : TransportSettings
{
    /// <inheritdoc/>
    public override string Address => string.Create(
        CultureInfo.InvariantCulture, $"{(Tls == FtpTls.None ? "ftp" : "ftps")}://{User}@{Host}:{Port}/{Folder.TrimStart('/')}");

    /// <inheritdoc/>
    public override bool NeedsPassword => true;

    internal override bool IsSamePlace(TransportSettings other) =>
        other is FtpSettings o && ServerFolder.AreSame((Host, Port, Folder), (o.Host, o.Port, o.Folder));

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) => new FtpTransport(machine, this, secret, limit);
}
