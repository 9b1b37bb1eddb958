using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Tells systemd how a service is: a datagram to the socket that <c>NOTIFY_SOCKET</c> names. Source: sd_notify(3).</summary>
/// <param name="socketName">The variable's value: a path, or a name behind <c>@</c>; null where nobody wants to know.</param>
public sealed class SystemdNotice(string? socketName)
{
    /// <summary>The service works.</summary>
    public void Ready() => Send("READY=1");

    /// <summary>The service ends.</summary>
    public void Stopping() => Send("STOPPING=1");

    /// <summary>The service lives; systemd restarts one that does not say so in time.</summary>
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
            // A name in front of which @ stands is in the abstract space, where a zero byte takes the place of the @.
            socket.SendTo(Encoding.UTF8.GetBytes(state), new UnixDomainSocketEndPoint(socketName[0] == '@' ? '\0' + socketName[1..] : socketName));
        }
        catch (SocketException)
        {
            // Nobody listens any more: whether the cell works does not hang on it.
        }
    }
}
