namespace ErrorMatching.Jobs;

/// <summary>A line of a <see cref="PointTable"/> that should hold coordinates and does not.</summary>
/// <param name="Line">Its number, from 1.</param>
/// <param name="Text">What stands there.</param>
public sealed record PointTableFault(int Line, string Text);
