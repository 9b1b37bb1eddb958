using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>
/// An angle, counter-clockwise positive. Radians inside, degrees at every public surface of the system.
/// </summary>
/// <remarks>An angle keeps its turns: 370 degrees is not 10 degrees until <see cref="Normalized"/> is asked for.</remarks>
public readonly record struct Angle : IComparable<Angle>
{
    private Angle(double radians) => Radians = radians;

    /// <summary>The angle in radians.</summary>
    public double Radians { get; }

    /// <summary>The angle in degrees.</summary>
    public double Degrees => Radians * (180 / Math.PI);

    /// <summary>The same direction in (-180, 180] degrees.</summary>
    public Angle Normalized
    {
        get
        {
            var r = Math.IEEERemainder(Radians, 2 * Math.PI);
            return new(r <= -Math.PI ? r + (2 * Math.PI) : r);
        }
    }

    /// <summary>An angle given in radians.</summary>
    public static Angle FromRadians(double radians) => new(radians);

    /// <summary>An angle given in degrees.</summary>
    public static Angle FromDegrees(double degrees) => new(degrees * (Math.PI / 180));

    /// <summary>The unsigned angle between two directions, 0 to 180 degrees (equation 1 of Wang 2021, by the arc tangent, which keeps its digits near 0 and 180).</summary>
    public static Angle Between(Vector2 a, Vector2 b) => new(Math.Atan2(Math.Abs(a.Cross(b)), a.Dot(b)));

    /// <summary>The angle in degrees as text, whatever the culture.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Degrees} deg");

    /// <inheritdoc/>
    public int CompareTo(Angle other) => Radians.CompareTo(other.Radians);

    /// <summary>The sum of two angles.</summary>
    public static Angle operator +(Angle a, Angle b) => new(a.Radians + b.Radians);

    /// <summary>The difference of two angles.</summary>
    public static Angle operator -(Angle a, Angle b) => new(a.Radians - b.Radians);

    /// <summary>The opposite angle.</summary>
    public static Angle operator -(Angle a) => new(-a.Radians);

    /// <summary>A multiple of an angle.</summary>
    public static Angle operator *(Angle a, double factor) => new(a.Radians * factor);

    /// <summary>True if the first is smaller.</summary>
    public static bool operator <(Angle a, Angle b) => a.Radians < b.Radians;

    /// <summary>True if the first is larger.</summary>
    public static bool operator >(Angle a, Angle b) => a.Radians > b.Radians;

    /// <summary>True if the first is not larger.</summary>
    public static bool operator <=(Angle a, Angle b) => a.Radians <= b.Radians;

    /// <summary>True if the first is not smaller.</summary>
    public static bool operator >=(Angle a, Angle b) => a.Radians >= b.Radians;
}
