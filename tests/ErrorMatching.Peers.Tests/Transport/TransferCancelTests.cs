using System.Text;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>While a transfer hangs: no secret can be seen anywhere, and cancelling ends the programs at once.</summary>
public sealed class TransferCancelTests
{
    private static readonly TimeSpan Soon = TimeSpan.FromSeconds(20);

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
        await HangsAsync(c => program.SendAsync(peer.Open(proxy.Port, seconds: 300), c), () => !proxy.IsArmed, ["curl"], FtpPeer.Password);
        await proxy.QuietAsync();
        Assert.False(program.IsWhole("cancelling"));
        await program.MendAsync(peer.Open(), "cancelling");
    }

    [Fact]
    public async Task Sftp_shows_no_password_and_ends_when_it_is_cancelled()
    {
        SshPeer.IsNeeded();
        Assert.SkipUnless(OperatingSystem.IsLinux(), "What processes show is read from /proc.");
        Assert.SkipUnless(Environment.IsPrivilegedProcess, "Only the system's administrator may have an sshd ask for passwords.");
        using var peer = new SshPeer(passwords: true);
        using var proxy = new CutProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        program.Reset();
        proxy.Arm(new CutFault(CutKind.Stall, 0, true, 3500));
        var machine = peer.Open(s => s with { Port = proxy.Port, KeyFile = null }, seconds: 300);
        await HangsAsync(c => program.SendAsync(machine, c), () => !proxy.IsArmed, ["sftp", "ssh"], SshPeer.Password.Trim());
        await proxy.QuietAsync();
        Assert.False(program.IsWhole("cancelling"));
        await program.MendAsync(peer.Open(s => s with { KeyFile = null }), "cancelling");
    }

    // Starts a transfer, waits until it hangs, looks at all processes, cancels it.
    private static async Task HangsAsync(Func<CancellationToken, Task<TransportException?>> send, Func<bool> hangs, string[] programs, string secret)
    {
        using var cancel = CancellationTokenSource.CreateLinkedTokenSource(Token);
        var sending = send(cancel.Token);
        while (!hangs())
        {
            Assert.False(sending.IsCompleted, sending.IsCompletedSuccessfully ? sending.Result?.Message : "It ended.");
            await Task.Delay(10, Token);
        }

        var children = Descendants(Environment.ProcessId);
        Assert.All(programs, p => Assert.Contains(children, c => c.Name == p));
        foreach (var child in children.Where(c => programs.Contains(c.Name)))
        {
            Assert.DoesNotContain(secret, Read(child.Id, "cmdline"), StringComparison.Ordinal);
            Assert.DoesNotContain(secret, Read(child.Id, "environ"), StringComparison.Ordinal);
            Assert.Contains("LC_ALL=C", Read(child.Id, "environ"), StringComparison.Ordinal);
        }

        // Nor in a file of the transfer's folder.
        foreach (var file in Directory.GetDirectories(Path.GetTempPath(), "errormatch-??????").SelectMany(Directory.GetFiles).Where(IsRegular))
            Assert.DoesNotContain(secret, File.ReadAllText(file), StringComparison.Ordinal);

        await cancel.CancelAsync();
        var failure = await Assert.ThrowsAnyAsync<OperationCanceledException>(() => sending.WaitAsync(Soon, Token));
        Assert.DoesNotContain(secret, failure.ToString(), StringComparison.Ordinal);
        Assert.All(children.Where(c => programs.Contains(c.Name)), c => Assert.False(IsAlive(c.Id), $"{c.Name} goes on."));
    }

    private static bool IsRegular(string file) => new FileInfo(file) is { Exists: true, Length: > 0 };

    private static bool IsAlive(int id)
    {
        var state = Read(id, "stat");
        return state.Length > 0 && state[(state.LastIndexOf(')') + 2)..][0] is not ('Z' or 'X');
    }

    private static List<(int Id, string Name)> Descendants(int parent)
    {
        var all = new List<(int Id, string Name, int Parent)>();
        foreach (var folder in Directory.GetDirectories("/proc").Where(f => int.TryParse(Path.GetFileName(f), System.Globalization.CultureInfo.InvariantCulture, out _)))
        {
            var id = int.Parse(Path.GetFileName(folder), System.Globalization.CultureInfo.InvariantCulture);
            var stat = Read(id, "stat");
            if (stat.Length == 0)
                continue;
            var name = stat[(stat.IndexOf('(', StringComparison.Ordinal) + 1)..stat.LastIndexOf(')')];
            all.Add((id, name, int.Parse(stat[(stat.LastIndexOf(')') + 2)..].Split(' ')[1], System.Globalization.CultureInfo.InvariantCulture)));
        }

        var found = new List<(int Id, string Name)>();
        void Add(int of)
        {
            foreach (var (id, name, _) in all.Where(p => p.Parent == of))
            {
                found.Add((id, name));
                Add(id);
            }
        }

        Add(parent);
        return found;
    }

    // A process may end while it is looked at.
    private static string Read(int id, string what)
    {
        try
        {
            return Encoding.UTF8.GetString(File.ReadAllBytes($"/proc/{id}/{what}"));
        }
        catch (IOException)
        {
            return "";
        }
    }
}
