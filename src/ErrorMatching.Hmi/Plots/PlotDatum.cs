using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A value of a plot that can be asked for under the finger.</summary>
/// <param name="At">Where it is drawn, in the plot's units.</param>
/// <param name="Text">What it is, with its exact values and units, in a line or several.</param>
/// <param name="Index">Its number among the plot's data.</param>
public sealed record PlotDatum(Point2 At, string Text, int Index);
