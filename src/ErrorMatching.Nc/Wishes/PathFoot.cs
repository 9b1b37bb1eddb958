namespace ErrorMatching.Nc;

/// <summary>The point of a motion that is nearest to a place.</summary>
/// <param name="DistanceMm">Its distance, mm.</param>
/// <param name="Motion">The motion.</param>
/// <param name="Fraction">Its position on the motion, 0 to 1.</param>
internal readonly record struct PathFoot(double DistanceMm, int Motion, double Fraction);
