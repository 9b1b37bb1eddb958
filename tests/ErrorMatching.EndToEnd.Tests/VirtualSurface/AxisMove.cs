namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A straight move of a program.</summary>
/// <param name="From">Where it begins.</param>
/// <param name="To">Where it ends.</param>
/// <param name="IsRapid">True for G0.</param>
/// <param name="IsMeasuring">True if it stops at the touch of the probe.</param>
internal readonly record struct AxisMove(Place From, Place To, bool IsRapid, bool IsMeasuring);
