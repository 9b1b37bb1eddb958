namespace ErrorMatching.Hmi;

/// <summary>A straight piece of a path as it is drawn, in units of the screen.</summary>
/// <param name="X1">Where it begins.</param>
/// <param name="Y1">Where it begins.</param>
/// <param name="X2">Where it ends.</param>
/// <param name="Y2">Where it ends.</param>
/// <param name="Block">The block that it belongs to.</param>
/// <param name="IsRapid">True if nothing is cut.</param>
public readonly record struct MoveStroke(float X1, float Y1, float X2, float Y2, int Block, bool IsRapid);
