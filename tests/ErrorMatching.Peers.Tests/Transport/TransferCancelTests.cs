using System.Text.RegularExpressions;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>While a transfer hangs: no secret can be seen anywhere, and cancelling ends it at once.</summary>
public sealed partial class TransferCancelTests
{
    private static readonly TimeSpan Soon = TimeSpan.FromMinutes(2);

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task Curl_shows_no_password_and_ends_when_it_is_cancelled()
    {
        FtpPeer.IsNeeded();
        Assert.SkipUnless(OperatingSystem.IsLinux(), "What processes show is read from /proc.");
        using var peer = new FtpPeer(FtpTls.None);
        using var proxy = new FtpProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        program.Reset();
        proxy.Arm(new FtpFault { StallWriting = 1000 });
        await HangsAsync(
            c => program.SendAsync(peer.Open(proxy.Port, seconds: 300), c), proxy.Port, () => !proxy.IsArmed, ["curl"], FtpPeer.Password);
        await proxy.QuietAsync();
        Assert.False(program.IsWhole("cancelling"));
        await program.MendAsync(peer.Open(), "cancelling");
    }

    [Fact]
    public async Task Sftp_hangs_up_when_it_is_cancelled_and_tells_no_password()
    {
        SshPeer.IsNeeded();
        Assert.SkipUnless(Environment.IsPrivilegedProcess, "Only the system's administrator may have an sshd ask for passwords.");
        using var peer = new SshPeer(passwords: true);
        using var proxy = new CutProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        foreach (var after in new[] { 10, 1000, 3500 })
        {
            program.Reset();
            proxy.Arm(new CutFault(CutKind.Stall, 0, true, after));
            using var machine = peer.Open(s => s with { Port = proxy.Port, KeyFile = null }, seconds: 300);
            using var cancel = CancellationTokenSource.CreateLinkedTokenSource(Token);
            var sending = program.SendAsync(machine, cancel.Token);
            await UntilAsync(() => !proxy.IsArmed, sending);
            await cancel.CancelAsync();
            var failure = await Assert.ThrowsAnyAsync<OperationCanceledException>(() => sending.WaitAsync(Soon, Token));
            Assert.DoesNotContain(SshPeer.Password.Trim(), failure.ToString(), StringComparison.Ordinal);
            Assert.False(program.IsWhole("cancelling"));
        }

        using var mending = peer.Open(s => s with { KeyFile = null });
        await program.MendAsync(mending, "cancelling");
    }

    // Starts a transfer, waits until it hangs, looks at its processes and files, cancels it.
    private static async Task HangsAsync(
        Func<CancellationToken, Task<TransportException?>> send, int port, Func<bool> hangs, string[] programs, string secret)
    {
        using var cancel = CancellationTokenSource.CreateLinkedTokenSource(Token);
        var sending = send(cancel.Token);
        await UntilAsync(hangs, sending);

        // Other tests run the same programs at the same time: those are meant that are connected to this port.
        var own = ProcessTable.ConnectedTo(port);
        Assert.Equal(programs.Order(StringComparer.Ordinal), own.Select(p => p.Name).Order(StringComparer.Ordinal));
        foreach (var (id, _, _) in own)
        {
            Assert.DoesNotContain(secret, ProcessTable.Read(id, "cmdline"), StringComparison.Ordinal);
            Assert.DoesNotContain(secret, ProcessTable.Read(id, "environ"), StringComparison.Ordinal);
            Assert.Contains("LC_ALL=C", ProcessTable.Read(id, "environ"), StringComparison.Ordinal);
        }

        // Nor in a file of the transfer's folder.
        var folder = Assert.Single(own.SelectMany(p => FoldersOf(p.Id)).Distinct());
        var files = Directory.GetFiles(folder).Where(IsRegular).ToArray();
        Assert.NotEmpty(files);
        foreach (var file in files)
            Assert.DoesNotContain(secret, File.ReadAllText(file), StringComparison.Ordinal);

        await cancel.CancelAsync();
        var failure = await Assert.ThrowsAnyAsync<OperationCanceledException>(() => sending.WaitAsync(Soon, Token));
        Assert.DoesNotContain(secret, failure.ToString(), StringComparison.Ordinal);
        Assert.True(await ProcessTable.EndAsync(own.Select(p => p.Id)), $"{string.Join(" or ", programs)} goes on.");
        Assert.False(Directory.Exists(folder));
    }

    private static async Task UntilAsync(Func<bool> hangs, Task<TransportException?> sending)
    {
        while (!hangs())
        {
            Assert.False(sending.IsCompleted, sending.IsCompletedSuccessfully ? (await sending)?.Message : "It ended.");
            await Task.Delay(10, Token);
        }
    }

    private static bool IsRegular(string file) => new FileInfo(file) is { Exists: true, Length: > 0 };

    // The folder of a transfer: curl has a file in it open.
    private static IEnumerable<string> FoldersOf(int process) =>
        PrivateFolders().Matches(string.Join(
            '\0', [ProcessTable.Read(process, "cmdline"), .. ProcessTable.Open(process)])).Select(m => m.Groups["folder"].Value);

    [GeneratedRegex(@"(?<folder>/[^\0=""]*/errormatch-transfers-\w{6}/[0-9a-f]{32})/", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex PrivateFolders();
}
