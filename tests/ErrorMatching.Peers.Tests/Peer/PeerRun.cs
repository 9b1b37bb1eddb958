namespace ErrorMatching.Peers.Tests;

/// <summary>What the peer made of a program.</summary>
/// <param name="Motions">Its motions up to the end or to the block that it refuses.</param>
/// <param name="Refusal">Its message; null where it accepts the whole program.</param>
internal sealed record PeerRun(IReadOnlyList<PeerMotion> Motions, string? Refusal)
{
    /// <summary>The work offset and its rotation at the end.</summary>
    public PeerOrigin Origin { get; init; }

    /// <summary>What it would write to a log, line by line.</summary>
    public IReadOnlyList<string> Log { get; init; } = [];
}

/// <summary>A work offset, mm, and its rotation, degrees.</summary>
internal readonly record struct PeerOrigin(double X, double Y, double Rotation);
