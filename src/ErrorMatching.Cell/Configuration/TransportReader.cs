using System.Buffers.Binary;
using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads the way to a machine.</summary>
internal sealed class TransportReader(JsonItem item, CellPaths paths, CellProblems problems)
{
    public TransportSettings Read() => item["kind"].Text switch
    {
        "folder" => new FolderSettings(paths.Of(item["folder"])),
        "ftp" => ReadFtp(),
        _ => ReadSftp(),
    };

    private FtpSettings ReadFtp()
    {
        var tls = item.Find("tls")?.Text switch { "none" => FtpTls.None, "implicit" => FtpTls.Implicit, _ => FtpTls.Explicit };
        var pin = item.Find("pinnedKey");
        if (tls == FtpTls.None)
        {
            if (pin is not null)
            {
                problems.Refuse(pin, "pin-without-tls", "a pinned key for a connection that is not encrypted", "\"tls\": \"explicit\" or \"implicit\", or no pinned key");
            }

            problems.Warn(item["tls"], "plain-ftp", "FTP that is not encrypted", "\"explicit\" or \"implicit\", or SFTP, where the control has it: anybody on this network can read the password and change programs");
        }
        else if (pin is null)
        {
            problems.Refuse(item, "pin-missing", "no key \"pinnedKey\"", "the hash of the server's public key, sha256//...: without it no TLS connection is trusted; or \"tls\": \"none\"");
        }

        return new(item["host"].Text, (int)(item.Find("port")?.Number ?? (tls == FtpTls.Implicit ? 990 : 21)), item["user"].Text, ReadFolder("/"), tls, pin?.Text);
    }

    private SftpSettings ReadSftp()
    {
        var key = item["hostKey"];
        if (!IsHostKey(key.Text))
        {
            problems.Refuse(key, "bad-host-key", "a key whose text does not hold what its first word says", "the server's key as in known_hosts, whole: ssh-keyscan prints it");
        }

        return new(
            item["host"].Text, (int)(item.Find("port")?.Number ?? 22), item["user"].Text, ReadFolder("."), key.Text, item.Find("keyFile") is { } file ? paths.Of(file) : null);
    }

    private string ReadFolder(string usual)
    {
        if (item.Find("folder") is not { } folder)
        {
            return usual;
        }

        if (folder.Text.Split('/').Contains(".."))
        {
            problems.Refuse(folder, "folder-leads-up", $"the folder \"{folder.Text}\"", "a folder without ..");
        }

        return folder.Text;
    }

    // The text is the base 64 of a length, the kind again, and the key (RFC 4253, section 6.6).
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
