namespace ErrorMatching.Hmi;

/// <summary>A straight piece of a path, in screen units.</summary>
/// <param name="X1">Start, x.</param>
/// <param name="Y1">Start, y.</param>
/// <param name="X2">End, x.</param>
/// <param name="Y2">End, y.</param>
/// <param name="Block">Its block.</param>
/// <param name="IsRapid">True for a rapid move, which cuts nothing.</param>
public readonly record struct MoveStroke(float X1, float Y1, float X2, float Y2, int Block, bool IsRapid);
