using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A cell with the job of <see cref="ProbedPiece"/>: the log comes from the machine that gets the finishing program,
/// or is dropped as a file.</summary>
internal static class ProbedCell
{
    public const string Log = "PROBE.LOG";
    public const string Program = "FINISH.MPF";

    /// <summary>A cell whose machine is behind an FTP server.</summary>
    public static Task<ConfiguredCell> OfAsync(FtpPeer peer, bool keeps, int? port = null) => OfAsync(
        string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "kind": "ftp", "host": "127.0.0.1", "port": {{port ?? peer.Port}}, "user": "ftp", "folder": "{{peer.Folder}}", "tls": "none" }"""),
        keeps,
        FtpPeer.Password);

    /// <summary>A cell whose machine is behind an SFTP server.</summary>
    public static Task<ConfiguredCell> OfAsync(SshPeer peer, bool keeps, int? port = null) => OfAsync(
        string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "kind": "sftp", "host": "127.0.0.1", "port": {{port ?? peer.Port}}, "user": "{{Environment.UserName}}", "folder": "{{peer.Folder}}", "hostKey": "{{peer.HostKey}}", "keyFile": "{{peer.KeyFile}}" }"""),
        keeps);

    /// <summary>A cell whose machine is a folder <c>machine</c> of its own.</summary>
    public static async Task<ConfiguredCell> OfFolderAsync(bool keeps, string finished = """{ "endMark": "END" }""")
    {
        var cell = await OfAsync("""{ "kind": "folder", "folder": "machine" }""", keeps, finished: finished);
        Directory.CreateDirectory(cell.PathOf("machine"));
        return cell;
    }

    /// <summary>Waits until the finishing program of a log is verified at the machine,
    /// and fails the test unless it is what the console makes of the log.</summary>
    public static async Task FinishedAsync(ConfiguredCell cell, string machine, long id = 1)
    {
        var verified = await cell.Until(id, CorrectionState.Verified);
        Assert.Equal(("blade", "surface", Log), (verified.Job, verified.Piece, verified.FileName));
        Assert.Equal(await ProbedPiece.Program, File.ReadAllBytes(Path.Combine(machine, Program)));
        Assert.Null(cell.Store.VerifyAudit());
    }

    private static async Task<ConfiguredCell> OfAsync(
        string transport, bool keeps, string? password = null, string finished = """{ "endMark": "END" }""")
    {
        var cell = new ConfiguredCell($$"""
            "gauges": [
              { "name": "probe", "machine": "mill", "files": "*.LOG", "format": "probing-log", "finished": {{finished}}, "everyMs": 20, "keep": {{(keeps ? "true" : "false")}} },
              { "name": "dropped", "incoming": "incoming", "files": "*.LOG", "format": "probing-log", "finished": "rename", "everyMs": 20 }
            ],
            "machines": [{ "name": "mill", "dialect": "siemens-840d", "transport": {{transport}}, "attempts": 2, "slots": [{ "name": "A", "program": "{{Program}}" }] }],
            "jobs": [{
              "name": "blade", "job": "job/job.json", "gauges": ["probe", "dropped"], "machine": "mill", "slot": "A",
              "recognize": { "headerField": { "name": "PLAN", "pattern": "^{{await ProbedPiece.Plan}}$" } }
            }],
            "policy": { "approve": "automatic" }
            """) { Opens = m => MachineFolders.Open(m, () => password) };
        ProbedPiece.LayOut(cell.PathOf("job"));
        return cell;
    }
}
