using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>SFTP by OpenSSH's sftp against a real sshd.</summary>
public sealed class SftpTransportTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task A_folder_behind_the_server_does_what_folders_do()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        await MachineFolderLaws.HoldAsync(peer.Open(), peer.Folder);
        Assert.True(
            OperatingSystem.IsWindows() || File.GetUnixFileMode(Path.Combine(peer.Folder, "P1.MPF")).HasFlag(UnixFileMode.GroupRead),
            "The control, another user, must read the program.");
    }

    [Fact]
    public async Task A_password_is_answered_and_a_wrong_one_is_a_refused_login()
    {
        SshPeer.IsNeeded();
        Assert.SkipUnless(Environment.IsPrivilegedProcess, "Only the system's administrator may have an sshd ask for passwords.");
        using var peer = new SshPeer(passwords: true);
        var settings = peer.Machine(s => s with { KeyFile = null });
        await MachineFolderLaws.HoldAsync(MachineFolders.Open(settings, () => SshPeer.Password), peer.Folder);
        foreach (var wrong in new[] { "wrong", "", null, SshPeer.Password.Trim() })
        {
            var failure = await MachineFolderLaws.Fails(
                TransportError.Login, () => MachineFolders.Open(settings, () => wrong).ListAsync(Token));
            Assert.False(failure.IsWorthAnotherTry);
        }
    }

    [Fact]
    public async Task A_server_with_another_key_is_not_talked_to()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        foreach (var key in new[] { peer.OtherKey, "ssh-rsa AAAAB3NzaC1yc2EAAAADAQABAAAAgQC7" })
        {
            var folder = peer.Open(s => s with { HostKey = key });
            await MachineFolderLaws.Fails(TransportError.WrongServer, () => folder.WriteAsync("P1.MPF", new byte[] { 1 }, Token));
        }

        Assert.Empty(Directory.EnumerateFileSystemEntries(peer.Folder));
    }

    [Fact]
    public async Task A_key_that_the_server_does_not_know_is_a_refused_login()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        await MachineFolderLaws.Fails(
            TransportError.Login, () => peer.Open(s => s with { KeyFile = peer.StrangersKeyFile }).ListAsync(Token));
        await MachineFolderLaws.Fails(
            TransportError.Login, () => peer.Open(s => s with { KeyFile = peer.KeyFile + ".none" }).ListAsync(Token));
    }

    [Fact]
    public async Task A_machine_that_is_off_is_away()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var off = new ClosedPort();
        await MachineFolderLaws.Fails(TransportError.Away, () => peer.Open(s => s with { Port = off.Number }).ListAsync(Token));
        await MachineFolderLaws.Fails(
            TransportError.Away, () => peer.Open(s => s with { Host = "no-such-machine.invalid" }).ListAsync(Token));
    }

    [Fact]
    public async Task A_folder_that_is_not_there_is_denied_and_never_made()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        var folder = peer.Open(s => s with { Folder = peer.Folder + "/none" });
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ListAsync(Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.WriteAsync("P1.MPF", new byte[] { 1 }, Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ReadAsync("P1.MPF", 10, Token));
        Assert.False(Directory.Exists(peer.Folder + "/none"));
    }

    [Fact]
    public async Task A_server_that_does_not_rename_over_a_file_gets_a_program_in_two_steps()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer(options: "-P posix-rename");
        var program = new SentProgram(peer.Folder, "P1.MPF");
        program.Reset();
        File.WriteAllText(Path.Combine(peer.Folder, "other"), "M30");
        await MachineFolderLaws.Fails(TransportError.CannotReplace, () => peer.Open().RenameAsync("other", "P1.MPF", 100, Token));
        File.Delete(Path.Combine(peer.Folder, "other"));
        Assert.False(program.IsWhole("refusing"));
        Assert.Null(await program.SendAsync(peer.Open()));
        Assert.True(program.IsWhole("two steps"));
        Assert.Empty(program.Leftovers());

        // As a cut between the two steps leaves it.
        program.Reset();
        File.Move(Path.Combine(peer.Folder, "P1.MPF"), Path.Combine(peer.Folder, "P1.MPF.emold"));
        File.WriteAllBytes(Path.Combine(peer.Folder, "P1.MPF.17-0123abcd.emnew"), SentProgram.New);
        Assert.False(program.IsWhole("a cut", inTwoSteps: true));
        await program.MendAsync(peer.Open(), "a cut");
    }

    [Fact]
    public async Task A_program_that_is_replaced_keeps_a_name_until_it_was_looked_at()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        string On(string name) => Path.Combine(peer.Folder, name);
        File.WriteAllBytes(On("new"), [2]);
        Assert.Null(await peer.Open().ReplaceAsync("new", "P1.MPF", "aside", 10, Token));
        Assert.Equal([On("new")], Directory.GetFiles(peer.Folder));

        // Written into while the other one takes its place, as an editor does that keeps the file open.
        File.WriteAllBytes(On("P1.MPF"), [1]);
        await using (var editor = new FileStream(On("P1.MPF"), FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete))
        {
            var replaced = await peer.Open().ReplaceAsync("new", "P1.MPF", "aside", 10, Token);
            Assert.Equal([2], replaced!.There);
            Assert.Equal([1], replaced.Was);
            editor.WriteByte(3);
        }

        Assert.Equal([3], File.ReadAllBytes(On("aside")));
        Assert.Equal([2], File.ReadAllBytes(On("P1.MPF")));
        Assert.False(File.Exists(On("new")));

        using var refuses = new SshPeer(options: "-P posix-rename");
        File.WriteAllBytes(Path.Combine(refuses.Folder, "new"), [2]);
        File.WriteAllBytes(Path.Combine(refuses.Folder, "P1.MPF"), [1]);
        Assert.Null(await refuses.Open().ReplaceAsync("new", "P1.MPF", "aside", 10, Token));
        Assert.Equal(["P1.MPF", "new"], Directory.GetFiles(refuses.Folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
    }

    // By another writer than the cell, in the moment between the last look and the renaming.
    [Fact]
    public async Task What_is_saved_at_the_last_moment_gets_its_place_back()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        var program = new SentProgram(peer.Folder, "P1.MPF");
        program.Reset();
        var edited = "edited at the control"u8.ToArray();
        var saving = new WatchedFolder(peer.Open(), (what, isDone) =>
        {
            if (what == "replace P1.MPF"
                && !isDone
                && File.ReadAllBytes(Path.Combine(peer.Folder, "P1.MPF")).SequenceEqual(SentProgram.Old))
                File.WriteAllBytes(Path.Combine(peer.Folder, "P1.MPF"), edited);
        });
        var changed = await Assert.ThrowsAsync<ChangedAtMachineException>(() => program.SendAsync(saving));
        Assert.Equal(edited, changed.Found);
        Assert.Equal(edited, File.ReadAllBytes(Path.Combine(peer.Folder, "P1.MPF")));
        Assert.Empty(program.Leftovers());
    }

    [Fact]
    public async Task A_full_disk_is_named()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        File.CreateSymbolicLink(Path.Combine(peer.Folder, "full"), "/dev/full");
        await MachineFolderLaws.Fails(TransportError.Full, () => peer.Open().WriteAsync("full", new byte[] { 1 }, Token));
    }

    [Fact]
    public async Task A_folder_may_be_named_with_what_sftp_takes_for_something_else()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        var disk = Directory.CreateDirectory(Path.Combine(peer.Folder, "a \"b\" \\c *d? [e] #f 'g'")).FullName;
        await MachineFolderLaws.HoldAsync(peer.Open(s => s with { Folder = disk }), disk);
    }
}
