namespace ErrorMatching.Geometry;

/// <summary>The point of a surface closest to a given point. Lengths in millimeters.</summary>
/// <param name="At">The point, with derivatives.</param>
/// <param name="Offset">The displacement from it to the given point.</param>
/// <param name="Accuracy">Proven bound: no point of the surface is closer by more than this.</param>
public readonly record struct SurfaceFoot(SurfacePoint At, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the given point from the surface.</summary>
    public double Distance => Offset.Length;

    /// <summary>Height of the given point above the surface along its unit normal, negative on the other side.</summary>
    public double Height => Offset.Dot(At.Normal);

    /// <summary>Distance of the given point from the normal line at the foot: 0 if it is perpendicularly above the surface, otherwise the
    /// foot is on an edge.</summary>
    public double OffNormal => (Offset - (At.Normal * Height)).Length;
}
