using System.Globalization;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>As <see cref="FireKills"/> on a folder, with the machine behind a real FTP server:
/// it too never has a program in part.</summary>
public sealed class KillOverFtpTests
{
    private static readonly int Times = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_KILLS") ?? "4", CultureInfo.InvariantCulture);

    [Fact(Explicit = true)]
    public async Task An_FTP_server_never_has_a_program_in_part_however_often_the_process_dies()
    {
        FtpPeer.IsNeeded();
        using var ftp = new FtpPeer(ErrorMatching.Cell.FtpTls.None);
        using var cell = await FtpCell.Of(ftp, slots: 4);
        await FireKills.Run(cell, Times, seed: 8);
    }
}
