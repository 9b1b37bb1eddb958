namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A move to write: straight, or an arc about a center with a signed sweep (radians, counter-clockwise positive).</summary>
internal sealed record PathMove(Flat To, Flat? Center = null, double Sweep = 0);
