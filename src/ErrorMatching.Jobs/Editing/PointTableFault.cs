namespace ErrorMatching.Jobs;

/// <summary>A line of a <see cref="PointTable"/> that should contain coordinates and does not.</summary>
/// <param name="Line">Its number, from 1.</param>
/// <param name="Text">Its text.</param>
public sealed record PointTableFault(int Line, string Text);
