namespace ErrorMatching.Geometry;

/// <summary>A surface that balances points against the bending energy of a thin plate.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="Weight">Factor of the energy relative to the sum of squared distances, in mm^2.</param>
/// <param name="EffectiveParameters">Effective number of poles per coordinate: trace of the matrix from points to fitted points.</param>
public sealed record SmoothedSurface(SplineSurface Surface, double Weight, double EffectiveParameters);
