using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface of the piece, where the material ends: the nominal one, or the compensated one with the same parametrization and
/// boundaries.</summary>
/// <remarks>Lengths in millimeters, in the work offset shared by probing and cutting.</remarks>
/// <param name="Name">Its name in the file, or its number.</param>
/// <param name="Spline">The surface over its parameters.</param>
/// <param name="Region">The part of the parameters that belongs to the piece.</param>
/// <param name="Outside">+1 if the normal Du x Dv points out of the material, -1 if it points into it.</param>
public sealed record PartSurface(string Name, SplineSurface Spline, SurfaceRegion Region, int Outside)
{
    /// <summary>The unit normal out of the material.</summary>
    public Vector3 NormalOf(SurfacePoint at) => at.Normal * Outside;

    /// <summary>The unit normal out of the material at a pair of parameters.</summary>
    public Vector3 NormalAt(double u, double v) => NormalOf(Spline.At(u, v));
}
