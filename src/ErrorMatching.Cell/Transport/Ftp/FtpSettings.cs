using System.Globalization;
using ErrorMatching.Json;

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

/// <summary>Reads the settings of an FTP server.</summary>
internal static class FtpReader
{
    public static FtpSettings Read(JsonItem item, CellProblems problems)
    {
        var tls = item.Find("tls")?.Text switch { "none" => FtpTls.None, "implicit" => FtpTls.Implicit, _ => FtpTls.Explicit };
        var pin = item.Find("pinnedKey");
        if (tls == FtpTls.None)
        {
            if (pin is not null)
            {
                problems.Refuse(
                    pin,
                    "pin-without-tls",
                    "a pinned key for a connection that is not encrypted",
                    "\"tls\": \"explicit\" or \"implicit\", or no pinned key");
            }

            problems.Warn(
                item["tls"],
                "plain-ftp",
                "FTP that is not encrypted",
                "\"explicit\" or \"implicit\", or SFTP, where the control has it: anybody on this network can read the password and "
                    + "change programs");
        }
        else if (pin is null)
        {
            problems.Refuse(
                item,
                "pin-missing",
                "no key \"pinnedKey\"",
                "the hash of the server's public key, sha256//...: without it no TLS connection is trusted; or \"tls\": \"none\"");
        }

        var port = (int)(item.Find("port")?.Number ?? (tls == FtpTls.Implicit ? 990 : 21));
        return new(item["host"].Text, port, item["user"].Text, ServerFolder.Read(item, "/", problems), tls, pin?.Text);
    }
}
