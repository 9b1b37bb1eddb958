namespace ErrorMatching.Geometry;

/// <summary>The place of a surface that is closest to a point. Lengths in millimetres.</summary>
/// <param name="At">The place, with derivatives.</param>
/// <param name="Offset">The displacement that leads from the place to the point.</param>
/// <param name="Accuracy">Proven: no place of the surface is closer to the point by more than this.</param>
public readonly record struct SurfaceFoot(SurfacePoint At, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the point from the surface.</summary>
    public double Distance => Offset.Length;

    /// <summary>Height of the point over the surface along its unit normal, negative on the other side.</summary>
    public double Height => Offset.Dot(At.Normal);

    /// <summary>Distance of the point from the line through the place along the normal: 0 where the point stands upright on the surface, not 0 where the foot is on an edge because the upright one would be beyond it.</summary>
    public double OffNormal => (Offset - (At.Normal * Height)).Length;
}
