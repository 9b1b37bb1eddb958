namespace ErrorMatching.Geometry;

/// <summary>The place of a curve that is closest to a point. Lengths in millimetres.</summary>
/// <param name="T">Parameter of the place.</param>
/// <param name="Position">The place.</param>
/// <param name="Offset">The displacement that leads from the place to the point.</param>
/// <param name="Accuracy">Proven: no place of the curve is closer to the point by more than this.</param>
public readonly record struct CurveFoot(double T, Point3 Position, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the point from the curve.</summary>
    public double Distance => Offset.Length;
}
