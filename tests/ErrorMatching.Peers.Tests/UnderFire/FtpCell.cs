using System.Globalization;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A cell whose machine is behind an FTP server, set up at the console as its user does:
/// an administrator, then the machine's password.</summary>
internal static class FtpCell
{
    private const string Administrator = "long enough for anna";

    /// <summary>Sets it up.</summary>
    /// <param name="ftp">The server.</param>
    /// <param name="slots">How many slots its machine has.</param>
    /// <param name="port">Where the cell asks for the server, if something stands before it.</param>
    public static async Task<FireCell> Of(FtpPeer ftp, int slots, int? port = null)
    {
        var cell = new FireCell(
            slots,
            transport: string.Create(
                CultureInfo.InvariantCulture,
                $$"""{ "kind": "ftp", "host": "127.0.0.1", "port": {{port ?? ftp.Port}}, "user": "ftp", "folder": "{{ftp.Folder}}", "tls": "none" }"""),
            machine: ftp.Folder);
        await Type(cell, ["user", "add", cell.Configuration, "anna", "--role", "administrator", "--password-stdin"], Administrator);
        await Type(
            cell, ["cell", "secret", cell.Configuration, "vmc", "--user", "anna", "--password-stdin"], Administrator, FtpPeer.Password);
        return cell;
    }

    private static async Task Type(FireCell cell, IReadOnlyList<string> arguments, params string[] lines)
    {
        var run = await ConsoleRun.Typed(cell.Folder, arguments, lines);
        Assert.True(run.Exit == 0, run.Output + run.Error);
    }
}
