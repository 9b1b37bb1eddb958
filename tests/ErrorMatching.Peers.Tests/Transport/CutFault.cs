namespace ErrorMatching.Peers.Tests;

/// <summary>What a <see cref="CutProxy"/> does to a connection. It happens once.</summary>
/// <param name="Kind">What is done.</param>
/// <param name="Connection">To which connection, from 0, or <see cref="CutProxy.Any"/>.</param>
/// <param name="IsUp">True for the stream to the server.</param>
/// <param name="After">After how many bytes, or at which.</param>
internal sealed record CutFault(CutKind Kind, int Connection, bool IsUp, long After);
