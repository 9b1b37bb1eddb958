namespace ErrorMatching.Cell;

/// <summary>The displacement of the boundary or the surface at a measured point, in mm.</summary>
/// <param name="Point">The point's label in the job, or its number in the measuring plan.</param>
/// <param name="X">Along the program's X; for a mating in another plane, along that plane's first axis.</param>
/// <param name="Y">Along the program's Y, or the plane's second axis.</param>
/// <param name="Z">Along the program's Z; zero for a mating.</param>
public sealed record PointCorrection(string Point, double X, double Y, double Z)
{
    /// <summary>Its length in mm.</summary>
    public double LengthMm => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));
}
