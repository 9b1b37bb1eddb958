using ErrorMatching.Json;

namespace ErrorMatching.Cell;

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
