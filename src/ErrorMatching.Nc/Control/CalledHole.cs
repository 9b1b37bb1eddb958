namespace ErrorMatching.Nc;

/// <summary>Heights of one hole, mm along the tool axis.</summary>
/// <param name="Return">The return plane.</param>
/// <param name="Reference">The reference plane, origin of depths.</param>
/// <param name="Start">Where the feed begins: the safety distance above the reference plane.</param>
/// <param name="Depth">The bottom.</param>
internal readonly record struct CalledHole(double Return, double Reference, double Start, double Depth);
