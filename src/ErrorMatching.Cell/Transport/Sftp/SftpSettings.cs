using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using ErrorMatching.Json;

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

/// <summary>Reads the settings of an SFTP server.</summary>
internal static class SftpReader
{
    public static SftpSettings Read(JsonItem item, CellPaths paths, CellProblems problems)
    {
        var key = item["hostKey"];
        if (!IsHostKey(key.Text))
        {
            problems.Refuse(
                key,
                "bad-host-key",
                "a key whose text does not hold what its first word says",
                "the server's key as in known_hosts, whole: ssh-keyscan prints it");
        }

        var port = (int)(item.Find("port")?.Number ?? 22);
        var file = item.Find("keyFile") is { } named ? paths.Of(named) : null;
        return new(item["host"].Text, port, item["user"].Text, ServerFolder.Read(item, ".", problems), key.Text, file);
    }

    // The text is the base64 of a length, the key type again, and the key (RFC 4253, section 6.6).
    private static bool IsHostKey(string text)
    {
        var (kind, key) = text.Split(' ') is [var first, var second] ? (first, second) : ("", "");
        var bytes = new byte[key.Length];
        return Convert.TryFromBase64String(key, bytes, out var count)
            && count > 4
            && BinaryPrimitives.ReadUInt32BigEndian(bytes) is var length
            && length < count - 4
            && Encoding.ASCII.GetString(bytes, 4, (int)length) == kind;
    }
}
