namespace ErrorMatching.Geometry;

/// <summary>The point of a curve closest to a given point. Lengths in millimeters.</summary>
/// <param name="T">Its parameter.</param>
/// <param name="Position">Its position.</param>
/// <param name="Offset">The displacement from it to the given point.</param>
/// <param name="Accuracy">Proven bound: no point of the curve is closer by more than this.</param>
public readonly record struct CurveFoot(double T, Point3 Position, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the given point from the curve.</summary>
    public double Distance => Offset.Length;
}
