using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>What <c>cell check</c> finds at real servers, and that it changes nothing there.</summary>
public sealed class CheckedServersTests
{
    // Nobody listens there.
    private const int Nobody = 1;

    [Theory]
    [InlineData(nameof(FtpTls.None))]
    [InlineData(nameof(FtpTls.Explicit))]
    [InlineData(nameof(FtpTls.Implicit))]
    public async Task An_FTP_server_lets_the_cell_in_or_says_what_is_wrong(string kind)
    {
        FtpPeer.IsNeeded();
        var tls = Enum.Parse<FtpTls>(kind);
        using var peer = new FtpPeer(tls);
        Put(peer.Folder);
        await using var cell = Cell();
        FtpSettings right = new("127.0.0.1", peer.Port, "ftp", peer.Folder, tls, peer.PinnedKey);
        await FindsAsync(cell, right, FtpPeer.Password, null);
        await FindsAsync(cell, right, null, "secret-missing");
        await FindsAsync(cell, right, "wrong", "machine-login");
        await FindsAsync(cell, right with { Folder = peer.Folder + "/none" }, FtpPeer.Password, "machine-denied");
        await FindsAsync(cell, right with { Port = Nobody }, FtpPeer.Password, "machine-away");
        if (tls != FtpTls.None)
        {
            await FindsAsync(
                cell,
                right with { PinnedKey = "sha256//" + Convert.ToBase64String(new byte[32]) },
                FtpPeer.Password,
                "machine-wrong-server");
        }

        Untouched(peer.Folder);
    }

    [Fact]
    public async Task An_FTP_server_that_takes_no_file_lets_the_cell_in_and_what_was_not_tried_is_said()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None, "cmds_denied=STOR,DELE,RNFR,RNTO");
        Put(peer.Folder);
        await using var cell = Cell();
        var check = await FindsAsync(
            cell, new FtpSettings("127.0.0.1", peer.Port, "ftp", peer.Folder, FtpTls.None, null), FtpPeer.Password, null);
        Assert.StartsWith(
            "mill: whether programs may be written, renamed and deleted there was not tried",
            Assert.Single(check.Untried),
            StringComparison.Ordinal);
        Assert.Contains("logs may be renamed and deleted", check.Untried.Single(), StringComparison.Ordinal);
        Untouched(peer.Folder);
    }

    [Fact]
    public async Task An_SSH_server_lets_the_cell_in_by_a_key_or_says_what_is_wrong()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        Put(peer.Folder);
        await using var cell = Cell();
        SftpSettings right = new("127.0.0.1", peer.Port, Environment.UserName, peer.Folder, peer.HostKey, peer.KeyFile);
        await FindsAsync(cell, right, null, null);
        await FindsAsync(cell, right with { KeyFile = peer.StrangersKeyFile }, null, "machine-login");
        await FindsAsync(cell, right with { KeyFile = peer.KeyFile + ".none" }, null, "key-missing");
        await FindsAsync(cell, right with { HostKey = peer.OtherKey }, null, "machine-wrong-server");
        await FindsAsync(cell, right with { Folder = peer.Folder + "/none" }, null, "machine-denied");
        await FindsAsync(cell, right with { Port = Nobody }, null, "machine-away");
        Untouched(peer.Folder);
    }

    [Fact]
    public async Task An_SSH_server_lets_the_cell_in_by_a_password_or_says_what_is_wrong()
    {
        SshPeer.IsNeeded();
        Assert.SkipUnless(
            Environment.IsPrivilegedProcess && OperatingSystem.IsLinux(),
            "Only the system's administrator can give PAM a service of the tests' own.");
        using var peer = new SshPeer(passwords: true);
        Put(peer.Folder);
        await using var cell = Cell();
        SftpSettings right = new("127.0.0.1", peer.Port, Environment.UserName, peer.Folder, peer.HostKey, null);
        await FindsAsync(cell, right, SshPeer.Password, null);
        await FindsAsync(cell, right, "wrong", "machine-login");
        await FindsAsync(cell, right, null, "secret-missing");
        Untouched(peer.Folder);
    }

    private static ConfiguredCell Cell()
    {
        var cell = new ConfiguredCell("");
        ProbedPiece.LayOut(cell.PathOf("job"));
        return cell;
    }

    // One login and what came of it: with the log and the slot's program there, or one problem, told once.
    private static async Task<CellCheck> FindsAsync(ConfiguredCell cell, TransportSettings transport, string? password, string? code)
    {
        cell.Configuration = $$"""
            "gauges": [{ "name": "probe", "machine": "mill", "files": "*.LOG", "format": "probing-log", "keep": false }],
            "machines": [{ "name": "mill", "dialect": "siemens-840d", "transport": {{Text(transport)}}, "slots": [{ "name": "A", "program": "FINISH.MPF" }] }],
            "jobs": [{ "name": "blade", "job": "job/job.json", "gauges": ["probe"], "machine": "mill", "slot": "A", "recognize": { "fileName": "LOG" } }],
            "policy": { "approve": "person" }
            """;
        var settings = cell.Settings;
        foreach (var file in Directory.EnumerateFiles(cell.Folder, "cell.db*"))
        {
            File.Delete(file);
        }

        if (password is not null)
        {
            using var store = CellStore.Open(settings.Store, TimeProvider.System);
            new MachineSecrets(store, settings.KeysFolder).Set("mill", password, "anna");
        }

        var check = await CellCheck.OfAsync(settings, TestContext.Current.CancellationToken);
        var (machine, gauge) = (Assert.Single(check.Machines), Assert.Single(check.Gauges));
        if (code is null)
        {
            Assert.True(machine.Problem is null, machine.Problem?.Errors[0].Message);
            Assert.Equal(["FINISH.MPF", "PROBE.LOG"], machine.Names!.Order(StringComparer.Ordinal));
            Assert.Equal("PROBE.LOG", Assert.Single(gauge.Files).Name);
            Assert.Empty(check.Away);
        }
        else
        {
            var error = Assert.Single(Assert.Single(check.Away).Errors);
            Assert.True(code == error.Code, $"{code} expected: {error.Code}: {error.Message}");
            Assert.StartsWith("mill: ", error.Message, StringComparison.Ordinal);
            Assert.DoesNotContain(
                password ?? "no password", error.Message.Replace("wrong server", "", StringComparison.Ordinal), StringComparison.Ordinal);
            Assert.Empty(check.Untried);
        }

        return check;
    }

    private static string Text(TransportSettings transport) => transport switch
    {
        FtpSettings f => string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "kind": "ftp", "host": "{{f.Host}}", "port": {{f.Port}}, "user": "{{f.User}}", "folder": "{{f.Folder}}", "tls": "{{f.Tls.ToString().ToLowerInvariant()}}"{{(f.PinnedKey is null ? "" : $", \"pinnedKey\": \"{f.PinnedKey}\"")}} }"""),
        SftpSettings s => string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "kind": "sftp", "host": "{{s.Host}}", "port": {{s.Port}}, "user": "{{s.User}}", "folder": "{{s.Folder}}", "hostKey": "{{s.HostKey}}"{{(s.KeyFile is null ? "" : $", \"keyFile\": \"{s.KeyFile}\"")}} }"""),
        _ => throw new ArgumentOutOfRangeException(nameof(transport)),
    };

    private static void Put(string folder)
    {
        File.WriteAllText(Path.Combine(folder, "PROBE.LOG"), "ERRORMATCH PROBE PLAN 0123456789ABCDEF MM\n");
        File.WriteAllText(Path.Combine(folder, "FINISH.MPF"), "M30\n");
    }

    private static void Untouched(string folder)
    {
        Assert.Equal(
            ["FINISH.MPF", "PROBE.LOG"],
            Directory.EnumerateFileSystemEntries(folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        Assert.Equal("M30\n", File.ReadAllText(Path.Combine(folder, "FINISH.MPF")));
    }
}
