namespace ErrorMatching.Freeform;

/// <summary>The error of a point in a drawing.</summary>
/// <param name="Label">Name of the point.</param>
/// <param name="BeforeUm">Its error before, in micrometers.</param>
/// <param name="AfterUm">Its error after, in micrometers; null if unknown.</param>
internal sealed record PlottedError(string Label, double BeforeUm, double? AfterUm);
