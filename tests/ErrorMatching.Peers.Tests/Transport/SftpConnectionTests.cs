using System.Diagnostics;
using System.Security.Cryptography;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>The connection to an sshd: it is kept, replaced when it is dead, and opened to the pinned key alone.</summary>
public sealed class SftpConnectionTests
{
    private static readonly byte[] Program = "M30\n"u8.ToArray();

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task Many_programs_go_over_one_connection_that_ends_with_the_folder()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        using (var machine = peer.Open(s => s with { Port = proxy.Port }))
        {
            for (var n = 0; n < 5; n++)
            {
                program.Reset();
                Assert.Null(await program.SendAsync(machine));
                Assert.True(program.IsWhole("sending"));
            }

            Assert.Equal(1, proxy.Connections);
        }

        await proxy.QuietAsync();
    }

    [Fact]
    public async Task Slots_send_at_the_same_time_and_few_connections_remain()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        using var machine = peer.Open(s => s with { Port = proxy.Port });
        var programs = Enumerable.Range(1, 6).Select(n => new SentProgram(peer.Folder, $"P{n}.MPF")).ToArray();
        foreach (var program in programs)
            program.Reset();
        Assert.All(await Task.WhenAll(programs.Select(p => p.SendAsync(machine))), Assert.Null);
        Assert.All(programs, p => Assert.True(p.IsWhole("sending")));
        await Quiet.WhenAsync(() => proxy.Open <= 2, "all but two connections end");
    }

    [Fact]
    public async Task A_server_that_was_started_again_costs_a_login_and_no_attempt()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        using var machine = peer.Open(s => s with { Port = proxy.Port });
        Assert.Empty(await machine.ListAsync(Token));
        proxy.HangUp();
        await proxy.QuietAsync();

        // The thread that listens may not have heard of it yet: then the answer is what it is without a kept connection.
        TransportException? failure = null;
        try
        {
            Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
        }
        catch (TransportException e)
        {
            failure = e;
        }

        Assert.True(failure is null or { Error: TransportError.Away, IsWorthAnotherTry: true }, failure?.Message);
        Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
        Assert.Equal(2, proxy.Connections);
    }

    [Fact]
    public async Task A_connection_whose_other_end_is_gone_is_asked_and_replaced()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        var settings = (SftpSettings)peer.Machine(s => s with { Port = proxy.Port }).Transport;
        using var machine = new SftpTransport(
            "mill", settings, () => null, TimeSpan.FromSeconds(FtpPeer.Patience), new(TimeSpan.Zero, TimeSpan.FromMilliseconds(500)));
        Assert.Empty(await machine.ListAsync(Token));
        Assert.Empty(await machine.ListAsync(Token));
        Assert.Equal(1, proxy.Connections);

        // A machine that was switched off says nothing and answers nothing.
        proxy.Hold();
        var watch = Stopwatch.StartNew();
        Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
        Assert.Equal(2, proxy.Connections);
        Assert.True(watch.Elapsed < TimeSpan.FromSeconds(FtpPeer.Patience / 2));
    }

    [Fact]
    public async Task A_server_that_asks_whether_the_cell_is_still_there_gets_an_answer()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer(more: "ClientAliveInterval 1");
        using var proxy = new CutProxy(peer.Port);
        using var machine = peer.Open(s => s with { Port = proxy.Port });
        Assert.Empty(await machine.ListAsync(Token));
        var (up, down) = proxy.Passed;
        await Quiet.WhenAsync(() => proxy.Passed.Down > down && proxy.Passed.Up > up, "the server's question is answered");
        Assert.Equal(1, proxy.Connections);
    }

    [Theory]
    [InlineData("ed25519")]
    [InlineData("rsa")]
    [InlineData("ecdsa")]
    public async Task A_server_is_known_by_any_of_its_keys(string kind)
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer(false, "", "", "rsa", "ecdsa", "ed25519");
        using var machine = peer.Open(s => s with { HostKey = peer.HostKeyOf(kind) });
        Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
    }

    [Fact]
    public async Task What_key_was_found_and_which_is_pinned_is_said()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var machine = peer.Open(s => s with { HostKey = peer.OtherKey });
        var failure = await MachineFolderLaws.Fails(TransportError.WrongServer, () => machine.ListAsync(Token));
        var (found, wanted) = (await FingerprintAsync(peer.HostKey), await FingerprintAsync(peer.OtherKey));
        Assert.Contains(
            $"the server's key is ssh-ed25519 {found}, the pinned one is ssh-ed25519 {wanted}.", failure.Message, StringComparison.Ordinal);

        using var rsa = new SshPeer(false, "", "", "rsa");
        using var other = rsa.Open(s => s with { HostKey = peer.HostKey });
        failure = await MachineFolderLaws.Fails(TransportError.WrongServer, () => other.ListAsync(Token));
        Assert.Contains("rsa-sha2-512", failure.Message, StringComparison.Ordinal);
        Assert.Contains(await FingerprintAsync(peer.HostKey), failure.Message, StringComparison.Ordinal);

        using var dsa = peer.Open(s => s with { HostKey = "ssh-dss AAAAB3NzaC1kc3MAAACBAJ" });
        failure = await MachineFolderLaws.Fails(TransportError.WrongServer, () => dsa.ListAsync(Token));
        Assert.Contains("\"ssh-dss\"", failure.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("ed25519")]
    [InlineData("rsa")]
    [InlineData("ecdsa")]
    [InlineData("rsa", "-m", "PEM")]
    [InlineData("ecdsa", "-m", "PKCS8")]
    public async Task A_login_may_use_any_kind_and_form_of_key(string kind, params string[] form)
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var machine = peer.Open(s => s with { KeyFile = peer.Welcome("another", kind, "", form) });
        Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
    }

    [Fact]
    public async Task A_key_that_cannot_be_used_is_named_and_nothing_of_it_is_told()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        var locked = peer.Welcome("locked", "ed25519", "a passphrase");
        await RefusesAsync(locked, "passphrase");
        var damaged = locked + ".damaged";
        WriteOwn(damaged, File.ReadAllBytes(peer.KeyFile)[..^120]);
        await RefusesAsync(damaged, "no private key");
        var large = locked + ".large";
        WriteOwn(large, new byte[100_000]);
        await RefusesAsync(large, "100000 bytes");
        await RefusesAsync(locked + ".none", "cannot be read");
        if (!OperatingSystem.IsWindows())
        {
            var shown = peer.Welcome("shown", "ed25519");
            File.SetUnixFileMode(shown, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead);
            await RefusesAsync(shown, "chmod 600");
        }

        static void WriteOwn(string file, byte[] bytes)
        {
            File.WriteAllBytes(file, bytes);
            if (!OperatingSystem.IsWindows())
                File.SetUnixFileMode(file, UnixFileMode.UserRead | UnixFileMode.UserWrite);
        }

        async Task RefusesAsync(string file, string word)
        {
            using var machine = peer.Open(s => s with { KeyFile = file });
            var failure = await MachineFolderLaws.Fails(TransportError.Login, () => machine.ListAsync(Token));
            Assert.True(failure.Message.Contains(word, StringComparison.Ordinal), failure.Message);
            Assert.Contains(file, failure.Message, StringComparison.Ordinal);
            foreach (var line in File.Exists(file) ? File.ReadLines(file).Where(l => l.Length > 20 && l[0] != '-') : [])
                Assert.DoesNotContain(line, failure.ToString(), StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_password_answers_a_server_that_asks_for_it_as_a_question()
    {
        SshPeer.IsNeeded();
        Assert.SkipUnless(Environment.IsPrivilegedProcess, "Only the system's administrator may have an sshd ask for passwords.");
        using var peer = new SshPeer(passwords: true, more: "KbdInteractiveAuthentication yes\nPasswordAuthentication no");
        using (var machine = peer.Open(s => s with { KeyFile = null }))
            Assert.Equal(Program, await machine.WriteAsync("P1.MPF", Program, Token));
        foreach (var wrong in new[] { "wrong", "", null })
        {
            using var machine = MachineFolders.Open(peer.Machine(s => s with { KeyFile = null }), () => wrong);
            await MachineFolderLaws.Fails(TransportError.Login, () => machine.ListAsync(Token));
        }
    }

    // Several at once, so that their threads wait for a processor: what is on its way to be sent must not meet a cipher that is gone.
    [Fact]
    public async Task Large_programs_survive_the_changes_of_keys_on_their_way()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer(more: "RekeyLimit 200K");
        var four = new ParallelOptions { MaxDegreeOfParallelism = 4, CancellationToken = Token };
        await Parallel.ForEachAsync(Enumerable.Range(1, 4), four, async (n, token) =>
        {
            var (name, program) = ($"P{n}.MPF", new byte[1_500_001]);
            new Random(11 + n).NextBytes(program);
            using var machine = peer.Open();
            Assert.Equal(SHA256.HashData(program), SHA256.HashData(await machine.WriteAsync(name, program, token)));
            Assert.Equal(program, await machine.ReadAsync(name, program.Length, token));
            Assert.Equal(program, await File.ReadAllBytesAsync(Path.Combine(peer.Folder, name), token));
        });
    }

    [Fact]
    public async Task Only_plain_files_are_opened()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        string On(string name) => Path.Combine(peer.Folder, name);
        File.WriteAllText(On("real"), "M30");
        File.CreateSymbolicLink(On("link"), On("real"));
        Directory.CreateDirectory(On("folder"));
        using (var made = Process.Start("mkfifo", [On("pipe")]))
            await made.WaitForExitAsync(Token);
        using var machine = peer.Open();
        foreach (var name in new[] { "link", "folder", "pipe" })
            await MachineFolderLaws.Fails(TransportError.NotAFile, () => machine.ReadAsync(name, 10, Token));
        Assert.Equal("M30"u8.ToArray(), await machine.ReadAsync("real", 10, Token));
    }

    [Fact]
    public async Task A_folder_may_have_a_name_in_any_language()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        var disk = Directory.CreateDirectory(Path.Combine(peer.Folder, "Prögramme 加工程式 é")).FullName;
        using var machine = peer.Open(s => s with { Folder = disk });
        await MachineFolderLaws.HoldAsync(machine, disk);
        File.WriteAllText(Path.Combine(disk, "測頭.LOG"), "");
        Assert.Contains("測頭.LOG", await machine.ListAsync(Token));
    }

    // As OpenSSH itself computes it.
    private static async Task<string> FingerprintAsync(string key)
    {
        var start = new ProcessStartInfo("ssh-keygen", ["-l", "-f", "-"])
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        };
        using var process = Process.Start(start)!;
        await process.StandardInput.WriteLineAsync(key);
        process.StandardInput.Close();
        var said = await process.StandardOutput.ReadToEndAsync(Token);
        await process.WaitForExitAsync(Token);
        return said.Split(' ')[1];
    }
}
