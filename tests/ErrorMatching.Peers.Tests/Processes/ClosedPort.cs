using System.Net;
using System.Net.Sockets;

namespace ErrorMatching.Peers.Tests;

/// <summary>A loopback port at which nobody listens and, as long as this is not disposed, nobody can:
/// whoever connects is refused.</summary>
internal sealed class ClosedPort : IDisposable
{
    private readonly Socket _bound = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);

    public ClosedPort() => _bound.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    public int Number => ((IPEndPoint)_bound.LocalEndPoint!).Port;

    public void Dispose() => _bound.Dispose();
}
