namespace ErrorMatching.Peers.Tests;

/// <summary>What is done to a stream.</summary>
internal enum CutKind
{
    Cut,
    Stall,
    Corrupt,
}
