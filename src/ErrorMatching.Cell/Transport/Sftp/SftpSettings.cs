using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>An SFTP server. The password, if it is no key, is a secret of the store.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Port.</param>
/// <param name="User">The login's name.</param>
/// <param name="Folder">The programs' folder, as the server names it.</param>
/// <param name="HostKey">The server's key as in <c>known_hosts</c>, such as <c>ssh-ed25519 AAAA...</c>: another one is not talked to.</param>
/// <param name="KeyFile">The private key that logs in; null for a password.</param>
public sealed record SftpSettings(string Host, int Port, string User, string Folder, string HostKey, string? KeyFile) : TransportSettings
{
    /// <inheritdoc/>
    public override string? SignInKey => KeyFile;

    /// <inheritdoc/>
    public override string Address =>
        string.Create(CultureInfo.InvariantCulture, $"sftp://{User}@{Host}:{Port}/{Folder.TrimStart('/')}");

    /// <inheritdoc/>
    public override bool NeedsPassword => KeyFile is null;

    internal override bool IsSamePlace(TransportSettings other) =>
        other is SftpSettings o && ServerFolder.AreSame((Host, Port, Folder), (o.Host, o.Port, o.Folder));

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) => new SftpTransport(machine, this, secret, limit);
}
