using System.Net;
using System.Net.Sockets;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>Servers that answer 550 to a short list: to some that means a folder without files, to others one that is not there.</summary>
public sealed class ListedFolderTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task A_folder_without_files_is_empty()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        using var proxy = new FtpProxy(peer.Port);
        proxy.Arm(new() { Instead = ("NLST", "550 No files found.") });
        Directory.CreateDirectory(Path.Combine(peer.Folder, "deeper"));
        Assert.Empty(await peer.Open(proxy.Port).ListAsync(Token));
        Assert.False(proxy.IsArmed);
    }

    [Fact]
    public async Task A_folder_with_files_that_it_does_not_list_is_not_taken_for_an_empty_one()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        using var proxy = new FtpProxy(peer.Port);
        File.WriteAllText(Path.Combine(peer.Folder, "P1.MPF"), "M30");
        proxy.Arm(new() { Instead = ("NLST", "550 Not for you.") });
        await MachineFolderLaws.Fails(TransportError.Denied, () => peer.Open(proxy.Port).ListAsync(Token));
    }

    [Fact]
    public async Task A_folder_that_is_not_there_is_not_taken_for_an_empty_one()
    {
        using var server = new ObligingServer();
        var machine = new MachineSettings
        {
            Name = "mill",
            Transport = new FtpSettings("127.0.0.1", server.Port, "nc", "programs", FtpTls.None, null),
            Dialect = "siemens-840d",
            Slots = [],
            Timeout = TimeSpan.FromSeconds(60),
            Attempts = 1,
        };
        var folder = MachineFolders.Open(machine, () => "secret");
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ListAsync(Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.ReadAsync("P1.MPF", 10, Token));
        await MachineFolderLaws.Fails(TransportError.Denied, () => folder.DeleteAsync("P1.MPF", Token));
    }

    /// <summary>An FTP server that enters any folder, as some simple ones do, and has none.</summary>
    private sealed class ObligingServer : IDisposable
    {
        private readonly LoopbackServer _server = new(c => TalkAsync(c.GetStream()));

        public ObligingServer() => _server.Start();

        public int Port => _server.Port;

        public void Dispose() => _server.Dispose();

        private static async Task TalkAsync(NetworkStream stream)
        {
            using var data = new TcpListener(IPAddress.Loopback, 0);
            using var lines = new StreamReader(stream, Encoding.Latin1);
            await Say(stream, "220 Ready.");
            while (await lines.ReadLineAsync() is { } line)
            {
                if (line.StartsWith("EPSV", StringComparison.Ordinal))
                {
                    data.Start();
                }

                await Say(stream, line.Split(' ')[0] switch
                {
                    "USER" => "331 Password?",
                    "PASS" => "230 Welcome.",
                    "PWD" => "257 \"/\"",
                    "CWD" => "250 Of course.",
                    "TYPE" => "200 Yes.",
                    "EPSV" =>
                        FormattableString.Invariant($"229 Entering Extended Passive Mode (|||{((IPEndPoint)data.LocalEndpoint).Port}|)"),
                    "QUIT" => "221 Bye.",
                    _ => "550 No such file or directory.",
                });
            }
        }

        private static async Task Say(NetworkStream stream, string line) =>
            await stream.WriteAsync(Encoding.Latin1.GetBytes(line + "\r\n"));
    }
}
