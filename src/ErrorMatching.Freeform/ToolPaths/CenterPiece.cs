using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A straight segment of the path of the ball's center.</summary>
/// <param name="From">Its start.</param>
/// <param name="To">Its end.</param>
/// <param name="Along">Its unit direction; zero if both ends coincide.</param>
/// <param name="LengthMm">Its length.</param>
internal readonly record struct CenterPiece(Point3 From, Point3 To, Vector3 Along, double LengthMm);
