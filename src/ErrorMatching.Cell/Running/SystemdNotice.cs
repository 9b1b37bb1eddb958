using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Reports the service's state to systemd: a datagram to the socket named by <c>NOTIFY_SOCKET</c>. Source: sd_notify(3).</summary>
/// <param name="socketName">The variable's value: a path, or a name after <c>@</c>; null without a listener.</param>
public sealed class SystemdNotice(string? socketName)
{
    /// <summary>The service is ready.</summary>
    public void Ready() => Send("READY=1");

    /// <summary>The service is stopping.</summary>
    public void Stopping() => Send("STOPPING=1");

    /// <summary>The service is alive; systemd restarts one that does not report this in time.</summary>
    public void Alive() => Send("WATCHDOG=1");

    private void Send(string state)
    {
        if (string.IsNullOrEmpty(socketName) || OperatingSystem.IsWindows())
        {
            return;
        }

        using var socket = new Socket(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified);
        try
        {
            // A name with a leading @ is in the abstract namespace, where a zero byte replaces the @.
            socket.SendTo(
                Encoding.UTF8.GetBytes(state), new UnixDomainSocketEndPoint(socketName[0] == '@' ? '\0' + socketName[1..] : socketName));
        }
        catch (SocketException)
        {
            // The listener is gone; the cell must not depend on it.
        }
    }
}
