using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>FTP and FTPS by curl against a real vsftpd.</summary>
public sealed class FtpTransportTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData(nameof(FtpTls.None))]
    [InlineData(nameof(FtpTls.Explicit))]
    [InlineData(nameof(FtpTls.Implicit))]
    public async Task A_folder_behind_the_server_does_what_folders_do(string kind)
    {
        FtpPeer.IsNeeded();
        var tls = Enum.Parse<FtpTls>(kind);
        using var peer = new FtpPeer(tls);
        await MachineFolderLaws.HoldAsync(peer.Open(), peer.Folder);
    }

    [Theory]
    [InlineData("programs")]
    [InlineData("programs/", Explicit = true)]
    [InlineData("programs/of the mill")]
    public async Task A_folder_may_be_named_from_where_the_login_leads(string folder)
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        var disk = Directory.CreateDirectory(Path.Combine(peer.Folder, "..", folder)).FullName;
        await MachineFolderLaws.HoldAsync(MachineFolders.Open(peer.Machine(folder: folder), () => FtpPeer.Password), disk);
    }

    [Theory]
    [InlineData("/")]
    [InlineData("/etc", Explicit = true)]
    public async Task A_folder_may_be_named_from_the_root(string folder)
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        var names = await MachineFolders.Open(peer.Machine(folder: folder), () => FtpPeer.Password).ListAsync(Token);
        Assert.Contains(folder == "/" ? "etc" : "passwd", names);
    }

    [Theory]
    [InlineData(nameof(FtpTls.Explicit))]
    [InlineData(nameof(FtpTls.Implicit), Explicit = true)]
    public async Task A_server_with_another_key_gets_no_password(string kind)
    {
        FtpPeer.IsNeeded();
        var tls = Enum.Parse<FtpTls>(kind);
        using var peer = new FtpPeer(tls);
        var other = "sha256//" + Convert.ToBase64String(new byte[32]);
        var folder = MachineFolders.Open(peer.Machine(pinned: other), () => FtpPeer.Password);
        var failure = await MachineFolderLaws.Fails(TransportError.WrongServer, () => folder.WriteAsync("P1.MPF", new byte[] { 1 }, Token));
        Assert.DoesNotContain(FtpPeer.Password, failure.ToString(), StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(peer.Folder));
    }

    [Fact]
    public async Task A_server_without_TLS_is_not_talked_to_where_TLS_is_demanded()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        var settings = peer.Machine();
        settings = settings with
        {
            Transport = (FtpSettings)settings.Transport with
            {
                Tls = FtpTls.Explicit,
                PinnedKey = "sha256//" + Convert.ToBase64String(new byte[32])
            }
        };
        await MachineFolderLaws.Fails(
            TransportError.WrongServer, () => MachineFolders.Open(settings, () => FtpPeer.Password).ListAsync(Token));
    }

    [Theory]
    [InlineData("wrong")]
    [InlineData("", Explicit = true)]
    [InlineData(null)]
    [InlineData("with\r\nDELE P1.MPF")]
    public async Task A_wrong_password_is_a_refused_login(string? password)
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        File.WriteAllText(Path.Combine(peer.Folder, "P1.MPF"), "M30");
        var folder = MachineFolders.Open(peer.Machine(), () => password);
        var failure = await MachineFolderLaws.Fails(TransportError.Login, () => folder.ListAsync(Token));
        Assert.False(failure.IsWorthAnotherTry);
        Assert.True(File.Exists(Path.Combine(peer.Folder, "P1.MPF")));
    }

    [Fact]
    public async Task A_machine_that_is_off_is_away()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        using var off = new ClosedPort();
        var failure = await MachineFolderLaws.Fails(TransportError.Away, () => peer.Open(off.Number).ListAsync(Token));
        Assert.True(failure.IsWorthAnotherTry);
    }

    [Fact]
    public async Task A_folder_that_is_not_there_is_denied_and_never_made()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        var folder = MachineFolders.Open(peer.Machine(folder: peer.Folder + "/none"), () => FtpPeer.Password);
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ListAsync(Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.WriteAsync("P1.MPF", new byte[] { 1 }, Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ReadAsync("P1.MPF", 10, Token));
        Assert.False(Directory.Exists(peer.Folder + "/none"));
    }

    [Fact]
    public async Task What_the_server_forbids_is_denied_and_leaves_the_old_program()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None, "cmds_denied=RNFR,RNTO");
        File.WriteAllText(Path.Combine(peer.Folder, "P1.MPF"), "M30");
        var failure = await Assert.ThrowsAsync<TransportException>(
            () => new ProgramSender(peer.Open(), _ => true).SendAsync("P1.MPF", SentProgram.Hash("M30"u8), new byte[] { 1 }, "1", Token));
        Assert.Equal(TransportError.Denied, failure.Error);
        Assert.Equal(["P1.MPF"], Directory.EnumerateFileSystemEntries(peer.Folder).Select(f => Path.GetFileName(f)!));
        Assert.Equal("M30", File.ReadAllText(Path.Combine(peer.Folder, "P1.MPF")));
    }
}
