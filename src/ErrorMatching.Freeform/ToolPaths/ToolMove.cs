using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A straight move of the ball's center.</summary>
/// <param name="Center">Its end, in millimeters.</param>
/// <param name="IsRapid">True for positioning in the air, false for a move at feed.</param>
public readonly record struct ToolMove(Point3 Center, bool IsRapid);
