namespace ErrorMatching.Nc;

/// <summary>The point of a motion that is nearest to a place.</summary>
/// <param name="DistanceMm">How far it is.</param>
/// <param name="Motion">The motion.</param>
/// <param name="Fraction">Where on the motion it is, 0 to 1.</param>
internal readonly record struct PathFoot(double DistanceMm, int Motion, double Fraction);
