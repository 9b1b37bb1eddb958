using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Values that only arcs have.</summary>
internal readonly record struct StoredArc(Point2 Center, int Turns);
