using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A value of a plot that the user can select.</summary>
/// <param name="At">Where it is drawn, in plot units.</param>
/// <param name="Text">Its exact values with units, in one or more lines.</param>
/// <param name="Index">Its index among the plot's data.</param>
public sealed record PlotDatum(Point2 At, string Text, int Index);
