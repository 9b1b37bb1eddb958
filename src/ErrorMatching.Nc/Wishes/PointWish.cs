using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Wish for the end of one motion.</summary>
/// <param name="Motion">Position of the motion in the path.</param>
/// <param name="By">The displacement of its end, mm.</param>
public readonly record struct PointWish(int Motion, Vector3 By);
