using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class SystemdNoticeTests
{
    [Fact]
    public void Systemd_hears_that_the_service_works_lives_and_ends()
    {
        if (OperatingSystem.IsWindows())
        {
            // There is no systemd to hear it: nothing may go wrong.
            new SystemdNotice("/nowhere").Ready();
            Assert.True(OperatingSystem.IsWindows());
            return;
        }

        var folder = Directory.CreateTempSubdirectory("em-");
        try
        {
            var path = Path.Combine(folder.FullName, "n");
            using var systemd = new Socket(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified) { ReceiveTimeout = 10_000 };
            systemd.Bind(new UnixDomainSocketEndPoint(path));
            var notice = new SystemdNotice(path);
            notice.Ready();
            notice.Alive();
            notice.Stopping();
            Assert.Equal(["READY=1", "WATCHDOG=1", "STOPPING=1"], Enumerable.Range(0, 3).Select(_ => Next(systemd)));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Theory]
    [InlineData(null)]
    [InlineData("")]
    [InlineData("/nowhere/at/all")]
    public void Nobody_who_listens_is_no_trouble(string? socket) => Assert.Null(Record.Exception(() => new SystemdNotice(socket).Ready()));

    private static string Next(Socket socket)
    {
        var buffer = new byte[100];
        return Encoding.UTF8.GetString(buffer, 0, socket.Receive(buffer));
    }
}
