namespace ErrorMatching.Nc;

/// <summary>Heights of one hole, mm along the tool axis.</summary>
/// <param name="Return">The return plane.</param>
/// <param name="Reference">The reference plane, from which depths count.</param>
/// <param name="Start">Where feed begins: the safety distance over the reference plane.</param>
/// <param name="Depth">The bottom.</param>
internal readonly record struct CalledHole(double Return, double Reference, double Start, double Depth);
