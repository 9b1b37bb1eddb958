using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>Four vectors in space. Each operation has the same steps and rounding as four operations on <see cref="Vector3"/>.</summary>
/// <param name="X">The components along X.</param>
/// <param name="Y">The components along Y.</param>
/// <param name="Z">The components along Z.</param>
public readonly record struct FourVectors(Vector256<double> X, Vector256<double> Y, Vector256<double> Z)
{
    /// <summary>The Euclidean lengths.</summary>
    public Vector256<double> Length
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.Sqrt(Dot(this));
    }

    /// <summary>Four copies of a vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FourVectors Of(Vector3 v) => new(Vector256.Create(v.X), Vector256.Create(v.Y), Vector256.Create(v.Z));

    /// <summary>Combines four vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FourVectors Of(Vector3 first, Vector3 second, Vector3 third, Vector3 fourth) => new(
        Vector256.Create(first.X, second.X, third.X, fourth.X),
        Vector256.Create(first.Y, second.Y, third.Y, fourth.Y),
        Vector256.Create(first.Z, second.Z, third.Z, fourth.Z));

    /// <summary>One of the vectors.</summary>
    /// <param name="number">0 to 3.</param>
    public Vector3 this[int number] => new(X[number], Y[number], Z[number]);

    /// <summary>Pairwise sums.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FourVectors operator +(in FourVectors a, in FourVectors b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Pairwise differences.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FourVectors operator -(in FourVectors a, in FourVectors b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>Multiples, each with its own factor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FourVectors operator *(in FourVectors a, Vector256<double> factors) => new(a.X * factors, a.Y * factors, a.Z * factors);

    /// <summary>Pairwise scalar products.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> Dot(in FourVectors other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    /// <summary>Pairwise vector products.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FourVectors Cross(in FourVectors other) =>
        new((Y * other.Z) - (Z * other.Y), (Z * other.X) - (X * other.Z), (X * other.Y) - (Y * other.X));
}
