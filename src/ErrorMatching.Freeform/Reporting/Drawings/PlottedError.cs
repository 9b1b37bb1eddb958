namespace ErrorMatching.Freeform;

/// <summary>The error of a point in a drawing.</summary>
/// <param name="Label">What the point is called.</param>
/// <param name="BeforeUm">Its error before, in micrometres.</param>
/// <param name="AfterUm">Its error after, in micrometres; null where it is not known.</param>
internal sealed record PlottedError(string Label, double BeforeUm, double? AfterUm);
