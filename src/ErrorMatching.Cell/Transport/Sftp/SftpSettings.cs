using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>An SFTP server. If it uses a password instead of a key, the password is stored as a secret.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Port.</param>
/// <param name="User">The login name.</param>
/// <param name="Folder">The program folder, as the server names it.</param>
/// <param name="HostKey">The server's key as in <c>known_hosts</c>, such as <c>ssh-ed25519 AAAA...</c>; no other key is accepted.</param>
/// <param name="KeyFile">The private key for the login; null for a password.</param>
internal sealed record SftpSettings(string Host, int Port, string User, string Folder, string HostKey, string? KeyFile) : TransportSettings
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

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) =>
        new SftpTransport(machine, this, secret, limit);
}
