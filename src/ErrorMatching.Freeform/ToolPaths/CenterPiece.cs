using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A straight piece of the way of the ball's center.</summary>
/// <param name="From">Where it begins.</param>
/// <param name="To">Where it ends.</param>
/// <param name="Along">Its unit direction; zero if both are one point.</param>
/// <param name="LengthMm">Its length.</param>
internal readonly record struct CenterPiece(Point3 From, Point3 To, Vector3 Along, double LengthMm);
