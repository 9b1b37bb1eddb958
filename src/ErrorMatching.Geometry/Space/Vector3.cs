namespace ErrorMatching.Geometry;

/// <summary>A displacement in space, in millimetres where it is a length.</summary>
/// <param name="X">Component along X.</param>
/// <param name="Y">Component along Y.</param>
/// <param name="Z">Component along Z.</param>
public readonly record struct Vector3(double X, double Y, double Z)
{
    /// <summary>The displacement by nothing.</summary>
    public static Vector3 Zero => default;

    /// <summary>Euclidean length.</summary>
    public double Length => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));

    /// <summary>The sum of two displacements.</summary>
    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>The difference of two displacements.</summary>
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>A multiple of a displacement.</summary>
    public static Vector3 operator *(Vector3 a, double factor) => new(a.X * factor, a.Y * factor, a.Z * factor);
}
